// SPDX-License-Identifier: LGPL-2.1-or-later
// Drops on the plane z = 0 (gamma = 1, V = 2 pi/3) by the full system, whose liquid is a body with a pressure of its
// own, and by the reduced one, a constraint of volume and integrals over the surface; on the same cap, whose nodes move
// along the same directions.
#pragma once

#include "body_runs.h"

#include <pellicle/assembly/rim_directions.h>
#include <pellicle/base/constants.h>
#include <pellicle/discretization/filled_cap.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/kinematics/rigid_bodies.h>
#include <pellicle/potentials/constraints/enclosed_volume.h>
#include <pellicle/potentials/energies/gravity.h>
#include <pellicle/potentials/energies/surface_tension.h>
#include <pellicle/potentials/solids/body_force.h>
#include <pellicle/potentials/solids/compressible_liquid.h>
#include <pellicle/potentials/solids/incompressible_liquid.h>
#include <pellicle/potentials/solids/shear_drag.h>
#include <pellicle/potentials/wetting/base_integral.h>

#include <algorithm>
#include <cmath>

namespace pellicle::test
{
inline const Where in_liquid{Where::Part::bulk, "liquid"};
constexpr double drop_volume = 2. * pi / 3.;

enum class System
{
  reduced,
  full,
  full_as_printed,      ///< with the tangent (130) of the paper as printed
  full_dead_load,       ///< p_f itself is the cells' polynomial, the weight a dead load
  full_without_pressure ///< compressible, the law at every quadrature point
};

struct Drop
{
  bool axial          = true;
  unsigned int degree = 3;
  unsigned int cuts   = 1; ///< refinements
  double angle        = 90.;
  double weight       = 0.; ///< rho g
  double compliance   = 0.; ///< 1/K
  double drag         = 0.01;
  double tolerance    = 1e-11;
  int max_iterations  = 40;
};

struct Equilibrium
{
  NewtonResult newton;
  std::size_t n_unknowns = 0;
  double seconds         = 0.;
  double radius          = 0.; ///< of the circle with the wetted area
  double apex            = 0.;
  double energy          = 0.;
  double volume          = 0.;
  double pressure        = 0.; ///< p_v = p_f - rho b . x, mean over the quadrature points
  double spread          = 0.; ///< largest deviation from it
};

/** The tangent (130) as printed: + p_f div dx div Dx, and no grad:grad. */
struct LiquidAsPrinted
{
  static constexpr auto fields                      = IncompressibleLiquid::fields;
  static constexpr bool reparametrisation_invariant = false;
  IncompressibleLiquid liquid;

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData &data) const
  {
    return liquid.density(inputs, data);
  }
  void add_derivatives(const PointInputs<double, 2> &inputs, const PointData &data,
                       const PointDerivativeView &view) const
  {
    liquid.add_derivatives(inputs, data, view);
    if (!view.wants_hessian())
      return;
    const BulkVolumeDerivatives volume(inputs[0]);
    const double p = inputs[1].value()[0];
    for (unsigned int b = 0; b < 3; ++b)
      for (unsigned int a = 0; a <= b; ++a)
        view.add_hessian(0, 1 + a, 0, 1 + b,
                         p * volume.j_xx(a, b) + (p / volume.j) * outer(volume.j_x[a], volume.j_x[b]));
  }
};

/** - integral of f . x dV over the reference. */
struct DeadLoad
{
  static constexpr std::array<FieldUse, 1> fields{{{"position", Derivatives::bulk, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = false;
  Vector3<double> force;
  std::shared_ptr<const std::vector<ReferenceBasis>> reference;

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData &data) const
  {
    const Vector3<Number> &x = inputs[0].value();
    return -(*reference)[data.index].volume * (force[0] * x[0] + force[1] * x[1] + force[2] * x[2]);
  }
};

inline double bulk_volume(const SurfaceDiscretization &drop, const NodalVectors &positions)
{
  const BulkPart &liquid = drop.bulks[0];
  double volume          = 0.;
  for_all_points(liquid.tables, liquid.cell_nodes, positions, 4,
                 [&](const WalkPoint &x) { volume += x.weight * dot(x[1], cross(x[2], x[3])); });
  return volume;
}

/** The start: a cap of the drop's angle whose cells have the drop's volume. */
inline SurfaceDiscretization start_of(const Drop &drop)
{
  const double theta = drop.angle * pi / 180., h = 1. - std::cos(theta),
               R             = std::cbrt(drop_volume / (pi / 3. * h * h * (3. - h)));
  SurfaceDiscretization mesh = filled_cap(theta, 2. * pi * R * R * h, drop.degree, drop.cuts, drop.axial);
  // As many points as the liquid has, so that volume and gravity are exact in both systems.
  mesh.tables        = drop.axial ? make_meridian_tables(drop.degree, 2 * drop.degree, false)
                                  : make_surface_tables(drop.degree, 2 * drop.degree);
  const double scale = std::cbrt(drop_volume / bulk_volume(mesh, mesh.positions));
  for (double &x : mesh.positions)
    x *= scale;
  mesh.mesh_reference = mesh.positions;
  return mesh;
}

/** The cap alone: its nodes are the first ones. */
inline SurfaceDiscretization without_liquid(SurfaceDiscretization mesh)
{
  mesh.n_nodes = mesh.bulks[0].faces["cap"].size();
  mesh.positions.resize(3 * mesh.n_nodes);
  mesh.mesh_reference.resize(3 * mesh.n_nodes);
  mesh.admissible.resize(mesh.n_nodes);
  mesh.bulks.clear();
  return mesh;
}

/** Nodes of the cap move along directions transversal to it, those of the line along the plane. Tangential forces on
 * them are of the size of the discretisation error, and have to do with the mesh alone. */
inline NodalConditions along_directions(const SurfaceDiscretization &mesh)
{
  SurfaceDiscretization cap = without_liquid(mesh);
  FieldConditions on_plane;
  on_plane.body.resize(cap.n_nodes);
  for (const std::size_t I : cap.edges[0].cell_nodes)
  {
    // The body keeps the line on the plane; its normal is to be that of the cap.
    cap.admissible[I] = {};
    if (cap.kind == SurfaceDiscretization::Kind::meridian)
      keep_on_plane(cap, {I}, {0., 1., 0.});
    on_plane.body[I] = std::make_shared<HalfSpace>(Vector3<double>(), Vector3<double>(0., 0., 1.));
  }
  const NodalVectors d = directions_towards_bodies(on_plane, cap, cap.positions, nodal_normals(cap, cap.positions));
  NodalConditions conditions;
  auto &only = conditions["position"].only;
  only.resize(cap.n_nodes);
  for (std::size_t I = 0; I < cap.n_nodes; ++I)
    only[I] = AdmissibleDirections{1, {{{{d[3 * I], d[3 * I + 1], d[3 * I + 2]}}, {}, {}}}};
  return conditions;
}

/** The liquid's part of the lists; takes the body away where the reduced system does without. */
inline void add_liquid(const Drop &drop, const System system, SurfaceDiscretization &mesh, PotentialSet &set)
{
  const Vector3<double> f(0., 0., -drop.weight);
  if (system == System::reduced)
  {
    set.energies.push_back(std::make_shared<DensityPotential<Gravity>>("gravity", Gravity{f}));
    Constraint volume;
    volume.measure = std::make_shared<DensityPotential<EnclosedVolume>>("volume", EnclosedVolume{});
    volume.target  = drop_volume;
    if (drop.compliance > 0.)
      volume.stiffness = 1. / (drop.compliance * drop_volume); // K/V0
    set.constraints.push_back(volume);
    mesh = without_liquid(std::move(mesh));
    return;
  }
  const auto reference =
      std::make_shared<const std::vector<ReferenceBasis>>(reference_bases(mesh.bulks[0], mesh.positions));
  if (system == System::full_dead_load)
    set.energies.push_back(std::make_shared<DensityPotential<DeadLoad>>("weight", DeadLoad{f, reference}, in_liquid));
  else
    set.energies.push_back(std::make_shared<DensityPotential<BodyForce>>("weight", BodyForce{f}, in_liquid));
  const IncompressibleLiquid liquid{{drop.compliance}, reference};
  if (system == System::full_without_pressure)
    set.energies.push_back(std::make_shared<DensityPotential<ElasticBody<CompressibleLiquid>>>(
        "liquid", ElasticBody<CompressibleLiquid>{{1. / drop.compliance}, reference}, in_liquid));
  else if (system == System::full_as_printed)
    set.energies.push_back(
        std::make_shared<DensityPotential<LiquidAsPrinted>>("liquid", LiquidAsPrinted{liquid}, in_liquid));
  else
    set.energies.push_back(std::make_shared<DensityPotential<IncompressibleLiquid>>("liquid", liquid, in_liquid));
  set.energies.push_back(std::make_shared<DensityPotential<ShearDrag>>("drag", ShearDrag{drop.drag}, in_liquid));
  if (system != System::full_without_pressure)
    add_pressure_nodes(mesh, 0);
}

/** Mean and spread of p_f - rho b . x over the quadrature points. */
inline void measure_pressure(const Drop &drop, const System system, const SurfaceDiscretization &mesh,
                             const SurfaceState &state, Equilibrium &result)
{
  const BulkPart &liquid = mesh.bulks[0];
  std::vector<double> pressures;
  for_all_points(liquid.tables, liquid.cell_nodes, state.fields[1], 1,
                 [&](const WalkPoint &p) { pressures.push_back(p[0][0]); });
  std::size_t point = 0;
  if (system == System::full_dead_load)
    for_all_points(liquid.tables, liquid.cell_nodes, state.fields[0], 1,
                   [&](const WalkPoint &x) { pressures[point++] += drop.weight * x[0][2]; });
  for (const double p : pressures)
    result.pressure += p / static_cast<double>(pressures.size());
  for (const double p : pressures)
    result.spread = std::max(result.spread, std::abs(p - result.pressure));
}

inline Equilibrium equilibrium_of(const Drop &drop, const System system)
{
  SurfaceDiscretization mesh = start_of(drop);
  PotentialSet set;
  set.energies.push_back(std::make_shared<DensityPotential<SurfaceTension>>("liquid surface", SurfaceTension{1.}));
  set.energies.push_back(
      make_wetting("wetting", PlaneChart{}, {-1., {std::cos(drop.angle * pi / 180.), nullptr}}, "rim"));
  const NodalConditions conditions = along_directions(mesh);
  add_liquid(drop, system, mesh, set);
  BodyRun run(mesh, set, conditions);
  run.parameters.tolerance      = drop.tolerance;
  run.parameters.max_iterations = drop.max_iterations;
  Equilibrium result;
  result.newton     = run.solve();
  result.seconds    = run.timing.total();
  result.n_unknowns = run.problem.residual().size();

  const SurfaceState &state = run.problem.state();
  const NodalVectors &x     = run.positions();
  const EdgeLoop &rim       = mesh.edges[0];
  const BaseIntegral<PlaneChart, AreaIntegrand> base{{}, {}, &middle_rule()};
  double wetted = 0.;
  for_all_points(rim.tables, rim.cell_nodes, x, 2,
                 [&](const WalkPoint &at) { wetted += at.weight * base.along_line(at[0], at[1]); });
  result.radius = std::sqrt(wetted / pi);
  for (const std::size_t I : mesh.cell_nodes)
    result.apex = std::max(result.apex, x[3 * I + 2]);
  for (const double energy : run.problem.values().energies)
    result.energy += energy;
  if (system == System::reduced)
  {
    result.volume   = run.problem.values().constraints[0];
    result.pressure = -state.multipliers[0];
    if (drop.compliance > 0.)
      result.energy += 0.5 * drop.compliance * drop_volume * result.pressure * result.pressure;
    return result;
  }
  result.volume = bulk_volume(mesh, x);
  if (system != System::full_without_pressure)
    measure_pressure(drop, system, mesh, state, result);
  return result;
}
} // namespace pellicle::test
