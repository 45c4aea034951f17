// SPDX-License-Identifier: LGPL-2.1-or-later
// A closed drop (contact angle 180 degrees) rests on an elastic block: liquid surface and solid touch, in one quarter.
#include "pair_runs.h"

#include "../mpi_environment.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/potentials/constraints/enclosed_volume.h>
#include <pellicle/potentials/energies/gravity.h>
#include <pellicle/potentials/energies/surface_tension.h>

#include <gtest/gtest.h>

#include <iostream>
#include <map>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double volume = 2. * pi / 3.;

/** The part of a surface in x > 0, y > 0, with planes of symmetry. */
SurfaceDiscretization quarter_of(const SurfaceDiscretization &whole)
{
  SurfaceDiscretization quarter;
  quarter.degree = whole.degree;
  quarter.tables = make_surface_tables(whole.degree, 2 * whole.degree); // gravity: see Gravity
  std::map<std::size_t, std::size_t> number;
  for (std::size_t c = 0; c < whole.n_cells; ++c)
  {
    const std::size_t *nodes = whole.cell_nodes.data() + c * whole.n_local();
    double x = 0., y = 0.;
    for (std::size_t i = 0; i < whole.n_local(); ++i)
    {
      x += whole.positions[3 * nodes[i]];
      y += whole.positions[3 * nodes[i] + 1];
    }
    if (x < 0. || y < 0.)
      continue;
    ++quarter.n_cells;
    for (std::size_t i = 0; i < whole.n_local(); ++i)
    {
      const auto [found, is_new] = number.emplace(nodes[i], number.size());
      quarter.cell_nodes.push_back(found->second);
      if (is_new)
        for (unsigned int d = 0; d < 3; ++d)
          quarter.positions.push_back(whole.positions[3 * nodes[i] + d]);
    }
  }
  quarter.n_nodes        = number.size();
  quarter.mesh_reference = quarter.positions;
  for (unsigned int d = 0; d < 2; ++d)
  {
    std::vector<std::size_t> on_plane;
    for (std::size_t I = 0; I < quarter.n_nodes; ++I)
      if (std::abs(quarter.positions[3 * I + d]) < 1e-12)
        on_plane.push_back(I);
    keep_on_plane(quarter, on_plane, d == 0 ? Vector3<double>(1., 0., 0.) : Vector3<double>(0., 1., 0.));
  }
  return quarter;
}

struct RestingDrop
{
  double height = 0., base_pressure = 0., radius = 0.; ///< sqrt(weight/(pi base pressure))
  double reaction      = 0.;                           ///< of the block over the weight
  double contact_force = 0.;                           ///< over the weight
  int iterations = 0, augmentations = 0;
  std::string failure;
};

RestingDrop rest(const unsigned int refinements, const unsigned int n_block, const double E, const double rho_g,
                 const double penalty, const int n_augmentations)
{
  const double R             = std::cbrt(0.5);
  SurfaceDiscretization drop = quarter_of(on_cube_sphere(ellipsoid({{R, R, R}}), 2, refinements));
  for (std::size_t I = 0; I < drop.n_nodes; ++I)
    drop.positions[3 * I + 2] += R - 0.02;
  SurfaceDiscretization base =
      block("block", {cell_ends(0., 1.5, n_block), cell_ends(0., 1.5, n_block), cell_ends(-1., 0., 3)}, 2);
  keep_on_plane(base, base.bulks[0].faces["left"], {1., 0., 0.});
  keep_on_plane(base, base.bulks[0].faces["front"], {0., 1., 0.});
  const SurfaceDiscretization all = joined(drop, without_surface(base), {"", ""});
  NodalConditions conditions;
  hold_nodes(conditions, "position", all.bulks[0].faces.at("bottom"), all.n_nodes);

  const auto potentials = [&](const double load)
  {
    PotentialSet set;
    set.energies.push_back(std::make_shared<DensityPotential<SurfaceTension>>("liquid surface", SurfaceTension{1.}));
    set.energies.push_back(std::make_shared<DensityPotential<Gravity>>("gravity", Gravity{{0., 0., -load}}));
    set.energies.push_back(solid_of(all, 0, NeoHookeanSolid::from_young(E, 0.3)));
    Constraint keeps_volume;
    keeps_volume.measure    = std::make_shared<DensityPotential<EnclosedVolume>>("volume", EnclosedVolume{});
    keeps_volume.target     = volume / 4.;
    keeps_volume.quantity   = "volume";
    keeps_volume.multiplier = "pressure";
    set.constraints.push_back(keeps_volume);
    return set;
  };
  BodyRun run(all, potentials(rho_g), conditions);
  run.parameters.tolerance = 1e-11;
  ContactLaw law{penalty, {0.3, 0.3}};
  std::vector<std::size_t> cells;
  const auto pairs   = std::make_shared<ContactPairs>(surface_cells(drop), surface_cells(base, {}, drop.n_nodes),
                                                    all.positions, law, "drop and block");
  SurfaceState start = run.problem.state();
  start.multipliers  = {-2. / R};
  run.problem.set_state(start);
  run.problem.set_pairs(std::make_shared<PairTerms>(std::vector<std::shared_ptr<PairTerm>>{pairs}, run.communicator));

  RestingDrop result;
  for (const double load : {0.1, 0.3, 0.6, 1.})
  {
    run.problem.set_potentials(potentials(load * rho_g));
    run.problem.use_chart(PositionChart::ale, all.mesh_reference);
    const AugmentedResult step = solve_with_pairs(run, 1e9);
    result.iterations += step.iterations;
    result.failure = step.failure;
    if (!step.converged)
      return result;
  }
  for (int i = 0; i < n_augmentations; ++i)
  {
    run.problem.pairs()->augment(run.positions(), 0.);
    {
      double ch = 0, big = 0;
      (void)ch;
      (void)big;
    }
    const AugmentedResult step = solve_with_pairs(run, 1e9);
    const auto pc              = pairs->pending();
    std::cout << "aug " << i << " its " << step.iterations << " pending " << pc.relative() << " biggest "
              << pc.largest_traction << " p " << -run.problem.state().multipliers[0] << " " << step.failure << "\n";
    result.iterations += step.iterations;
    result.failure = step.failure;
    if (!step.converged)
      return result;
  }
  const NodalVectors &x = run.positions();
  double apex = 0., lowest = 1.;
  for (std::size_t I = 0; I < drop.n_nodes; ++I)
  {
    apex   = std::max(apex, x[3 * I + 2]);
    lowest = std::min(lowest, x[3 * I + 2]);
  }
  const double weight  = rho_g * volume;
  result.height        = apex - lowest;
  result.base_pressure = -run.problem.state().multipliers[0] - rho_g * lowest;
  result.radius        = std::sqrt(weight / (pi * result.base_pressure));
  result.reaction      = 4. * force_along_z(run.problem.nodal_forces().total, all.bulks[0].faces.at("bottom")) / weight;
  result.contact_force = 4. * force_along_z(run.problem.pair_forces(), all.bulks[0].faces.at("top")) / weight;
  return result;
}

TEST(DropOnBlock, Try)
{
  const RestingDrop d =
      rest(atoi(getenv("REF")), atoi(getenv("NB")), atof(getenv("E")), 1., atof(getenv("EPS")), atoi(getenv("TOL")));
  printf("height %.8f (1.243774869) radius %.8f (.448665072) reaction-1 %.3e contact-1 %.3e its %d aug %d %s\n",
         d.height, d.radius, d.reaction - 1., d.contact_force - 1., d.iterations, d.augmentations, d.failure.c_str());
}
} // namespace
