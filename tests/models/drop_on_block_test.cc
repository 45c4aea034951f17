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

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double volume = 2. * pi / 3.;

/** The part of a surface in x > 0, y > 0, with planes of symmetry. */
SurfaceDiscretization quarter_of(const SurfaceDiscretization &whole)
{
  const auto is_inside = [&](const std::size_t c)
  {
    double x = 0., y = 0.;
    for (std::size_t i = 0; i < whole.n_local(); ++i)
    {
      x += whole.positions[3 * whole.cell_nodes[c * whole.n_local() + i]];
      y += whole.positions[3 * whole.cell_nodes[c * whole.n_local() + i] + 1];
    }
    return x > 0. && y > 0.;
  };
  SurfaceDiscretization quarter = part_of(whole, is_inside, 2 * whole.degree); // for gravity: see Gravity
  quarter.edges.clear();                                                       // symmetry: the surface goes on
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

/** Lengths in which gamma = 1 and V = 2 pi/3. */
struct RestingDrop
{
  double height        = 0.;
  double base_pressure = 0., radius = 0.; ///< sqrt(weight/(pi base pressure))
  double reaction   = 0.;                 ///< of the block, over the weight
  double depression = 0.;                 ///< of the block's top
  int iterations    = 0;
};

class DropOnBlock
{
public:
  DropOnBlock(const unsigned int refinements, const unsigned int n_block, const double E)
      : drop(start_drop(refinements))
      , base(start_block(n_block))
      , all(joined(drop, without_surface(base), {"", ""}))
      , solid(solid_of(all, 0, NeoHookeanSolid::from_young(E, 0.3)))
      , run(all, potentials(0.), held_bottom(all))
  {
    run.parameters.tolerance = 1e-11;
    pairs = std::make_shared<ContactPairs>(surface_cells(drop), surface_cells(base, {}, drop.n_nodes), all.positions,
                                           ContactLaw{200., {0.3, 0.3}}, "drop and block");
    SurfaceState start = run.problem.state();
    start.multipliers  = {-2. / radius};
    run.problem.set_state(start);
    run.problem.set_pairs(std::make_shared<PairTerms>(std::vector<std::shared_ptr<PairTerm>>{pairs}, run.communicator));
  }

  /** In steps to rho g, then augmentations. */
  void load(const double rho_g, const int n_augmentations)
  {
    weight_density = rho_g;
    for (const double part : {0.1, 0.3, 0.6, 1.})
    {
      run.problem.set_potentials(potentials(part * rho_g));
      run.problem.use_chart(PositionChart::ale, all.mesh_reference);
      solve();
    }
    for (int i = 0; i < n_augmentations; ++i)
    {
      run.problem.pairs()->augment(run.positions(), 0.);
      solve();
    }
  }
  RestingDrop measure() const
  {
    RestingDrop result;
    const NodalVectors &x = run.positions();
    double apex = 0., lowest = 1.;
    for (std::size_t I = 0; I < drop.n_nodes; ++I)
    {
      apex   = std::max(apex, x[3 * I + 2]);
      lowest = std::min(lowest, x[3 * I + 2]);
    }
    const double weight  = weight_density * volume;
    result.height        = apex - lowest;
    result.base_pressure = -run.problem.state().multipliers[0] - weight_density * lowest;
    result.radius        = std::sqrt(weight / (pi * result.base_pressure));
    for (const std::size_t I : all.bulks[0].faces.at("top"))
      result.depression = std::max(result.depression, -x[3 * I + 2]);
    const NodalVectors forces = run.problem.nodal_forces().total;
    result.reaction           = 4. * force_along_z(forces, all.bulks[0].faces.at("bottom")) / weight;
    result.iterations         = iterations;
    return result;
  }
  bool has_mesh_equations_in_the_block() const
  {
    const NodalChart &chart = run.problem.numbering().charts[0];
    for (std::size_t I = drop.n_nodes; I < all.n_nodes; ++I)
      for (unsigned int a = 0; a < chart.nodes[I].count; ++a)
        if (chart.nodes[I].mesh_equation[a])
          return true;
    return false;
  }
  bool has_mesh_equations() const { return run.problem.numbering().charts[0].has_mesh_equations(); }

private:
  static SurfaceDiscretization start_drop(const unsigned int refinements)
  {
    SurfaceDiscretization sphere = quarter_of(on_cube_sphere(ellipsoid({{radius, radius, radius}}), 2, refinements));
    for (std::size_t I = 0; I < sphere.n_nodes; ++I)
      sphere.positions[3 * I + 2] += radius - 0.02;
    return sphere;
  }
  static SurfaceDiscretization start_block(const unsigned int n)
  {
    SurfaceDiscretization body =
        block("block", {cell_ends(0., 1.5, n), cell_ends(0., 1.5, n), cell_ends(-1., 0., 3)}, 2);
    keep_on_plane(body, body.bulks[0].faces["left"], {1., 0., 0.});
    keep_on_plane(body, body.bulks[0].faces["front"], {0., 1., 0.});
    return body;
  }
  static NodalConditions held_bottom(const SurfaceDiscretization &all)
  {
    NodalConditions conditions;
    hold_nodes(conditions, "position", all.bulks[0].faces.at("bottom"), all.n_nodes);
    return conditions;
  }
  PotentialSet potentials(const double rho_g) const
  {
    PotentialSet set;
    set.energies.push_back(std::make_shared<DensityPotential<SurfaceTension>>("liquid surface", SurfaceTension{1.}));
    set.energies.push_back(std::make_shared<DensityPotential<Gravity>>("gravity", Gravity{{0., 0., -rho_g}}));
    set.energies.push_back(solid);
    Constraint keeps_volume;
    keeps_volume.measure    = std::make_shared<DensityPotential<EnclosedVolume>>("volume", EnclosedVolume{});
    keeps_volume.target     = volume / 4.;
    keeps_volume.quantity   = "volume";
    keeps_volume.multiplier = "pressure";
    set.constraints.push_back(keeps_volume);
    return set;
  }
  void solve()
  {
    const NewtonResult result = run.solve();
    ASSERT_TRUE(result.converged) << result.failure;
    iterations += result.iterations;
  }

  static constexpr double radius = 0.79370052598409974; // (1/2)^(1/3)

  SurfaceDiscretization drop, base, all;
  std::shared_ptr<const Potential> solid;
  BodyRun run;
  std::shared_ptr<ContactPairs> pairs;
  double weight_density = 0.;
  int iterations        = 0;
};

// Against the drop on a rigid plane (Young-Laplace, rho g = 1): a = .448665072 from the pressure at the base, h =
// 1.243774869. The liquid's equations are those along the normals; the tangential forces that they leave are of the
// size of the discretisation error, and so is what the block's reaction lacks of the weight.
TEST(DropOnBlock, NearlyRigidBlock)
{
  std::vector<double> heights, radii, imbalances;
  for (const unsigned int level : {1u, 2u})
  {
    DropOnBlock scene(level, 3 * level, 1e4);
    scene.load(1., 3);
    EXPECT_TRUE(scene.has_mesh_equations());
    EXPECT_FALSE(scene.has_mesh_equations_in_the_block());
    const RestingDrop drop = scene.measure();
    EXPECT_LE(drop.iterations, 35);
    heights.push_back(std::abs(drop.height / 1.243774869 - 1.));
    radii.push_back(std::abs(drop.radius / .448665072 - 1.));
    imbalances.push_back(std::abs(drop.reaction - 1.));
  }
  EXPECT_LT(heights[1], 1e-3);
  EXPECT_LT(radii[1], 3e-4);
  EXPECT_LT(imbalances[1], 4e-3);
  EXPECT_GT(std::log2(heights[0] / heights[1]), 2.5);
  EXPECT_GT(std::log2(radii[0] / radii[1]), 2.5);
  EXPECT_GT(std::log2(imbalances[0] / imbalances[1]), 2.5);
}

// The block gives way by an amount that falls with its stiffness, E in gamma/length.
TEST(DropOnBlock, SoftBlocks)
{
  std::vector<double> depressions;
  for (const double E : {20., 200., 2000.})
  {
    DropOnBlock scene(1, 3, E);
    scene.load(0.3, 2);
    const RestingDrop drop = scene.measure();
    depressions.push_back(drop.depression);
    EXPECT_NEAR(drop.reaction, 1., 0.05) << E;
  }
  EXPECT_GT(depressions[2], 0.);
  EXPECT_GT(depressions[0], 5. * depressions[1]) << depressions[1];
  EXPECT_GT(depressions[1], 3. * depressions[2]) << depressions[2];
}
} // namespace
