// SPDX-License-Identifier: LGPL-2.1-or-later
// The rim of a membrane tied to the top of a block, against a rim that shares the block's nodes.
#include "pair_runs.h"

#include "../mpi_environment.h"

#include <pellicle/assembly/contact_ties.h>
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/potentials/energies/mesh_distortion.h>
#include <pellicle/potentials/energies/surface_tension.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** An elastic film that bulges over the middle cell of the top of a block of 3 x 3 x 1 cells, and pulls its rim in. */
struct FilmOnBlock
{
  SurfaceDiscretization film, base, all;

  FilmOnBlock()
      : base(block("block", {cell_ends(0., 3., 3), cell_ends(0., 3., 3), {0., 1.}}, 2))
  {
    for (std::size_t I = 0; I < base.n_nodes; ++I)
      base.positions[3 * I + 2] -= 1.;
    const SurfaceDiscretization patch = block("", {{1., 2.}, {1., 2.}, {-1., 0.}}, 2);
    film                              = part_of(
                                     patch, [](std::size_t) { return true; }, 3);
    for (std::size_t I = 0; I < film.n_nodes; ++I)
    {
      const double x = film.positions[3 * I] - 1., y = film.positions[3 * I + 1] - 1.;
      film.positions[3 * I + 2] += 4. * x * (1. - x) * y * (1. - y);
    }
    film.mesh_reference = film.positions;
    all                 = joined(film, without_surface(base), {"", ""});
  }

  PotentialSet potentials() const
  {
    PotentialSet set;
    set.energies.push_back(std::make_shared<DensityPotential<SurfaceTension>>("tension", SurfaceTension{0.3}));
    set.energies.push_back(make_mesh_distortion(reference_metric(all, all.positions)));
    set.energies.push_back(solid_of(all, 0, {2., 3.}));
    return set;
  }
  NodalConditions held_bottom() const
  {
    NodalConditions conditions;
    hold_nodes(conditions, "position", all.bulks[0].faces.at("bottom"), all.n_nodes);
    return conditions;
  }
  /** And nodes of the rim follow those of the block that are at the same place. */
  NodalConditions shared_rim() const
  {
    NodalConditions conditions        = held_bottom();
    std::vector<std::size_t> &leaders = conditions["position"].leader;
    for (std::size_t I = 0; I < all.n_nodes; ++I)
      leaders.push_back(I);
    for (const std::size_t I : film.edges[0].cell_nodes)
      for (std::size_t J = film.n_nodes; J < all.n_nodes; ++J)
        if (norm(vector_at(all.positions, I) - vector_at(all.positions, J)) < 1e-12)
          leaders[I] = J;
    return conditions;
  }
};

TEST(TiedRim, EqualsSharedNodes)
{
  const FilmOnBlock scene;
  BodyRun tied(scene.all, scene.potentials(), scene.held_bottom());
  tied.parameters.tolerance = 1e-12;
  const auto ties           = std::make_shared<ContactTies>(SlavePoints(scene.film.edges[0], scene.all.positions),
                                                  surface_cells(scene.base, {4}, scene.film.n_nodes),
                                                  scene.all.positions, 1e3, SearchLimits{0.1, 0.1}, "rim");
  ASSERT_EQ(ties->points().size(), 4u * 3u);
  tied.problem.set_pairs(std::make_shared<PairTerms>(std::vector<std::shared_ptr<PairTerm>>{ties}, tied.communicator));
  tied.problem.use_chart(PositionChart::material, {});
  const AugmentedResult result = solve_with_pairs(tied, 1e-9);
  ASSERT_TRUE(result.converged) << result.failure;
  RecordProperty("augmentations", result.augmentations);
  BodyRun shared(scene.all, scene.potentials(), scene.shared_rim());
  shared.parameters.tolerance  = 1e-12;
  const NewtonResult reference = shared.solve();
  ASSERT_TRUE(reference.converged) << reference.failure;

  double moved = 0., difference = 0.;
  for (std::size_t i = 0; i < scene.all.positions.size(); ++i)
  {
    moved      = std::max(moved, std::abs(shared.positions()[i] - scene.all.positions[i]));
    difference = std::max(difference, std::abs(shared.positions()[i] - tied.positions()[i]));
  }
  EXPECT_GT(moved, 2e-3);
  EXPECT_LT(difference, 1e-9);
  for (const TiedPoint &tie : ties->points())
    EXPECT_LT(norm(ties->gap(tie, tied.positions())), 1e-9);
}
} // namespace
