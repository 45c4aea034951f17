// SPDX-License-Identifier: LGPL-2.1-or-later
// A drop that floats on another liquid, without weight: two spherical caps and a flat surface meet in a circle at the
// angles of Neumann's triangle. In closed form, for any tensions.
#include "body_runs.h"

#include "../expect_user_error.h"
#include "../mpi_environment.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/liquid_lens.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/potentials/constraints/enclosed_volume.h>
#include <pellicle/potentials/energies/surface_tension.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double volume = 2. * pi / 3.;

/** Tensions of the upper and the lower cap and of the surface outside. */
struct Tensions
{
  double upper = 1., lower = 1., outer = 1.;
};
const std::vector<Tensions> many_tensions{{}, {.08, .10, .06}, {1., .8, .9}, {1., 1., 1.99}};

struct ExactLens
{
  double upper_angle, lower_angle; ///< between the caps and the plane of the line
  double radius, pressure;         ///< a of the line, p

  explicit ExactLens(const Tensions &t)
      : upper_angle(angle(t.upper, t.lower, t.outer))
      , lower_angle(angle(t.lower, t.upper, t.outer))
      , radius(std::cbrt(volume / (volume_over_disc(upper_angle) + volume_over_disc(lower_angle))))
      , pressure(2. * t.upper * std::sin(upper_angle) / radius)
  {
  }

private:
  static double angle(const double own, const double other, const double outer)
  {
    return std::acos((own * own + outer * outer - other * other) / (2. * own * outer));
  }
  /** Of a cap over the unit disc, by its height. */
  static double volume_over_disc(const double angle)
  {
    const double h = std::tan(0.5 * angle);
    return pi / 6. * h * (3. + h * h);
  }
};

PotentialSet potentials(const Tensions &tensions)
{
  const auto tension_of = [](const char *region, const double tension)
  {
    return std::make_shared<DensityPotential<SurfaceTension>>(region, SurfaceTension{tension},
                                                              Where{Where::Part::region, region});
  };
  const auto volume_below = [](const char *region)
  {
    return std::make_shared<DensityPotential<EnclosedVolume>>("volume", EnclosedVolume{},
                                                              Where{Where::Part::region, region});
  };
  PotentialSet set;
  set.energies = {tension_of(lens_upper_region, tensions.upper), tension_of(lens_lower_region, tensions.lower),
                  tension_of(lens_outer_region, tensions.outer)};
  Constraint keeps_volume;
  keeps_volume.measure       = volume_below(lens_upper_region);
  keeps_volume.further_parts = {volume_below(lens_lower_region)};
  keeps_volume.target        = volume;
  set.constraints.push_back(keeps_volume);
  return set;
}

struct Mesh
{
  unsigned int degree = 3, refinements = 2;
  bool axial = true;
};

/** A lens off its equilibrium by 5% of the radius and 10% of the angles. */
SurfaceDiscretization start_of(const ExactLens &exact, const Mesh &mesh)
{
  LensShape start;
  start.upper_angle  = exact.upper_angle * 0.9;
  start.lower_angle  = exact.lower_angle * 1.1;
  start.radius       = exact.radius * 1.05;
  start.outer_radius = 3. * start.radius;
  return liquid_lens(start, mesh.degree, mesh.refinements, mesh.axial);
}

/** Relative errors of an equilibrium, and what is left of the forces at the line. */
struct Lens
{
  double radius = 0., pressure = 0.;
  double out_of_circle = 0.;          ///< largest deviation of the line's nodes
  double force_at_node = 0.;          ///< largest on a node of the line, normal to the line, over length times tension
  std::array<double, 3> directions{}; ///< of the regions' tangents away from the line, degrees above the outward radius
};

/** Angles of tangents at the line's node of a meridian. */
std::array<double, 3> directions_at_line(const SurfaceDiscretization &mesh, const NodalVectors &positions)
{
  const std::size_t ring = mesh.edges[0].cell_nodes[0];
  const ShapeTables ends = make_tables_at(mesh.kind, mesh.degree, {{{0., 0.}}, {{1., 0.}}});
  std::array<double, 3> result{};
  for_all_cells(ends, mesh.cell_nodes, positions, 2,
                [&](const WalkCell &cell)
                {
                  for (const unsigned int end : {0u, 1u})
                    if (cell.nodes[end * mesh.degree] == ring)
                    {
                      const Vector3<double> t               = (end == 0 ? 1. : -1.) * cell[end][1];
                      result[mesh.cell_region[cell.number]] = std::atan2(t[2], t[0]) * 180. / pi;
                    }
                });
  return result;
}

Lens solve(const Tensions &tensions, const Mesh &form, const PositionChart chart = PositionChart::graph)
{
  const ExactLens exact(tensions);
  const SurfaceDiscretization mesh = start_of(exact, form);
  NodalConditions conditions;
  hold_nodes(conditions, "position", mesh.edges[1].cell_nodes, mesh.n_nodes);
  BodyRun run(mesh, potentials(tensions), conditions);
  run.parameters.tolerance = 1e-11;
  SurfaceState state       = run.problem.state();
  state.multipliers        = {-exact.pressure};
  run.problem.set_state(state);
  run.problem.use_chart(chart, mesh.mesh_reference);
  const NewtonResult result = run.solve();
  EXPECT_TRUE(result.converged) << result.failure;
  EXPECT_LE(result.iterations, 6);

  Lens lens;
  lens.pressure         = -run.problem.state().multipliers[0] / exact.pressure - 1.;
  const NodalVectors &x = run.positions(), forces = run.problem.nodal_forces().total;
  const std::size_t n_nodes = mesh.edges[0].cell_nodes.size();
  for (const std::size_t I : mesh.edges[0].cell_nodes)
  {
    const double r = std::hypot(x[3 * I], x[3 * I + 1]), error = r / exact.radius - 1.;
    const double along_r = (x[3 * I] * forces[3 * I] + x[3 * I + 1] * forces[3 * I + 1]) / r;
    lens.radius += error / static_cast<double>(n_nodes);
    lens.out_of_circle = std::max({lens.out_of_circle, std::abs(error), std::abs(x[3 * I + 2]) / exact.radius});
    lens.force_at_node =
        std::max(lens.force_at_node, std::hypot(along_r, forces[3 * I + 2]) / (2. * pi * r * tensions.upper));
  }
  if (mesh.kind == SurfaceDiscretization::Kind::meridian)
    lens.directions = directions_at_line(mesh, x);
  return lens;
}

TEST(LiquidLens, SurfacesShareTheLine)
{
  LensShape shape{1.3, 0.7, 1.9, 4.};
  for (const bool axial : {true, false})
  {
    const SurfaceDiscretization lens = liquid_lens(shape, 3, 2, axial);
    EXPECT_EQ(lens.n_cells, axial ? 8 + 8 + 16 : 12 * 16 + 12 * 16 + 4 * 8 * 16);
    EXPECT_EQ(lens.edges[0].name, lens_line);
    EXPECT_FALSE(lens.edges[0].is_rim);
    EXPECT_TRUE(lens.edges[1].is_rim);
    EXPECT_NEAR(loop_length(lens.edges[0], lens.positions), 2. * pi * shape.radius, 1e-6);
    EXPECT_NEAR(loop_length(lens.edges[1], lens.positions), 2. * pi * shape.outer_radius, 1e-5);
    // Sizes and orientations of the three surfaces, as sums of z n_z and of n_z over them.
    std::array<double, 3> volumes{}, shadows{};
    for_all_points(lens.tables, lens.cell_nodes, lens.positions, 3,
                   [&](const WalkPoint &x)
                   {
                     const std::size_t cell =
                         static_cast<std::size_t>(x.nodes - lens.cell_nodes.data()) / lens.n_local();
                     const double shadow = x.weight * cross(x[1], x[2])[2];
                     volumes[lens.cell_region[cell]] += shadow * x[0][2];
                     shadows[lens.cell_region[cell]] += shadow;
                   });
    const double disc = pi * shape.radius * shape.radius;
    const auto cap    = [&](const double angle)
    {
      const double h = shape.radius * std::tan(0.5 * angle);
      return pi / 6. * h * (3. * shape.radius * shape.radius + h * h);
    };
    EXPECT_NEAR(volumes[0], cap(shape.upper_angle), 1e-5);
    EXPECT_NEAR(volumes[1], cap(shape.lower_angle), 1e-3);
    EXPECT_NEAR(volumes[2], 0., 1e-14);
    EXPECT_NEAR(shadows[0], disc, 1e-5);
    EXPECT_NEAR(shadows[1], -disc, 1e-5);
    EXPECT_NEAR(shadows[2], pi * shape.outer_radius * shape.outer_radius - disc, 1e-4);
  }
  shape.lower_angle = pi;
  expect_user_error([&] { liquid_lens(shape, 3, 2, true); }, {"3.14159", "between 0 and pi"});
  expect_user_error([] { liquid_lens({2., 0.5, 0.5, 1.}, 3, 2, false); }, {"inner radius < outer radius"});
}

TEST(LiquidLens, EqualTensions)
{
  const ExactLens exact(Tensions{});
  EXPECT_NEAR(exact.radius, 1.012909456963, 1e-11);
  EXPECT_NEAR(exact.pressure, 1.709975946677, 1e-11);
  EXPECT_NEAR(exact.radius / std::sin(exact.upper_angle), 1.169607095285, 1e-11);
}

TEST(LiquidLens, AxialLensesAreExact)
{
  for (const Tensions &tensions : many_tensions)
  {
    const ExactLens exact(tensions);
    const Lens lens = solve(tensions, {});
    EXPECT_LT(std::abs(lens.radius), 2e-9);
    EXPECT_LT(std::abs(lens.pressure), 2e-9);
    EXPECT_LT(lens.out_of_circle, 2e-9);
    EXPECT_NEAR(lens.directions[0], 180. - exact.upper_angle * 180. / pi, 0.004);
    EXPECT_NEAR(lens.directions[1], -180. + exact.lower_angle * 180. / pi, 0.004);
    EXPECT_NEAR(lens.directions[2], 0., 1e-10);
  }
}

// Surfaces that the line carries along feel its motion smoothly. In the ALE chart only the line's own node does: the
// force on that node vanishes, and the order is k + 1.
TEST(LiquidLens, OrderOfConvergence)
{
  const Tensions tensions{1., .8, .9};
  const double exact_direction = 180. - ExactLens(tensions).upper_angle * 180. / pi;
  for (const unsigned int degree : {2u, 3u})
    for (const PositionChart chart : {PositionChart::graph, PositionChart::ale})
    {
      const bool carried = chart == PositionChart::graph;
      const Lens coarse = solve(tensions, {degree, 1}, chart), fine = solve(tensions, {degree, 2}, chart);
      const auto order = [](const double a, const double b) { return std::log2(std::abs(a / b)); };
      SCOPED_TRACE(std::to_string(degree) + (carried ? " graph" : " ale"));
      EXPECT_NEAR(order(coarse.radius, fine.radius), carried ? 2. * degree : degree + 1., 0.3);
      EXPECT_NEAR(order(coarse.pressure, fine.pressure), carried ? 2. * degree : degree + 1., 0.3);
      if (carried)
      {
        EXPECT_NEAR(order(coarse.force_at_node, fine.force_at_node), degree + 1., 0.3);
      }
      else
      {
        EXPECT_LT(fine.force_at_node, 1e-11);
      }
      if (degree == 3)
      {
        EXPECT_NEAR(order(coarse.directions[0] - exact_direction, fine.directions[0] - exact_direction), degree, 0.3);
      }
    }
}

TEST(LiquidLens, InSpace)
{
  for (const Tensions &tensions : {many_tensions[1], many_tensions[2]})
  {
    const Lens carried = solve(tensions, {3, 1, false}), ale = solve(tensions, {3, 1, false}, PositionChart::ale);
    EXPECT_LT(std::abs(carried.radius), 1.5e-6);
    EXPECT_LT(std::abs(carried.pressure), 2e-7);
    EXPECT_LT(carried.out_of_circle, 5e-6);
    EXPECT_LT(std::abs(ale.radius), 1.5e-6);
    EXPECT_LT(std::abs(ale.pressure), 3e-6);
    EXPECT_LT(ale.out_of_circle, 1.5e-5);
    EXPECT_LT(ale.force_at_node, 1e-9);
  }
}
} // namespace
