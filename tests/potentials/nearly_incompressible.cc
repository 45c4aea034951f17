// SPDX-License-Identifier: LGPL-2.1-or-later
// The effect "solid" through the solver: a disc squeezed by a tenth between two plates it is glued to, where cells that
// know displacements alone lock as the Poisson ratio approaches 1/2.
#include "../models/body_runs.h"
#include "../mpi_environment.h"

#include <pellicle/potentials/solids/solid_effect.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

struct Squeezed
{
  double force   = 0.; ///< on the upper plate
  int iterations = 0;
};

/** Radius 2, height 1, E = 1; 2 n by n cells of the given degree. */
SurfaceDiscretization disc(const unsigned int n, const unsigned int degree)
{
  return cylinder(substrate_body, {cell_ends(0., 2., 2 * n), cell_ends(-1., 0., n)}, degree);
}

Squeezed squeeze(const SurfaceDiscretization &mesh, PotentialSet set)
{
  const auto &faces             = mesh.bulks[0].faces;
  std::vector<std::size_t> held = faces.at("bottom");
  held.insert(held.end(), faces.at("top").begin(), faces.at("top").end());
  NodalConditions conditions;
  hold_nodes(conditions, "position", held, mesh.n_nodes);
  BodyRun run(mesh, std::move(set), conditions);
  NodalVectors start = mesh.positions;
  for (std::size_t I = 0; I < mesh.n_nodes; ++I)
    start[3 * I + 2] = mesh.positions[3 * I + 2] - 0.1 * (mesh.positions[3 * I + 2] + 1.);
  run.place(start);
  const NewtonResult result = run.solve();
  EXPECT_TRUE(result.converged) << result.failure;
  Squeezed squeezed;
  squeezed.iterations      = result.iterations;
  const NodalVectors force = run.problem.nodal_forces().total;
  for (const std::size_t I : faces.at("top"))
    squeezed.force += force[3 * I + 2];
  return squeezed;
}

/** By the effect. */
Squeezed squeeze_solid(const double nu, const std::string &law, const unsigned int n, const unsigned int degree)
{
  SurfaceDiscretization mesh = disc(n, degree);
  SceneTargets targets;
  targets.substrate                 = RidgeTargets{};
  targets.substrate->poisson_ratio  = nu;
  targets.substrate->bulk_reference = reference_of(mesh);
  if (SolidEffect::uses_pressure(nu))
    add_pressure_nodes(mesh, 0);
  SolidEffect effect;
  effect.parameters.volumetric_law = law;
  PotentialSet set;
  effect.contribute(Scales{}, targets, set);
  return squeeze(mesh, std::move(set));
}

/** By displacements alone, logarithmic law. */
Squeezed squeeze_displacements(const double nu, const unsigned int n, const unsigned int degree)
{
  const SurfaceDiscretization mesh = disc(n, degree);
  PotentialSet set;
  set.energies.push_back(std::make_shared<DensityPotential<ElasticBody<NeoHookeanSolid>>>(
      "solid", ElasticBody<NeoHookeanSolid>{NeoHookeanSolid::from_young(1., nu), reference_of(mesh)},
      Where{Where::Part::bulk, substrate_body}));
  return squeeze(mesh, std::move(set));
}

// Errors on 8 x 4 cells: 1 % in mixed form, more than 10 % (nu = .499) in displacements alone; 4 iterations against 9.
TEST(NearlyIncompressible, MixedFormDoesNotLock)
{
  const double nu = 0.499, fine = squeeze_solid(nu, "logarithmic", 8, 3).force;
  const Squeezed mixed = squeeze_solid(nu, "logarithmic", 4, 2), alone = squeeze_displacements(nu, 4, 2);
  EXPECT_LT(std::abs(mixed.force / fine - 1.), 0.02);
  EXPECT_GT(std::abs(alone.force / fine - 1.), 0.1);
  EXPECT_LE(mixed.iterations, 6);
  EXPECT_LT(mixed.iterations, alone.iterations);
}

// Where both forms converge, to the same.
TEST(NearlyIncompressible, FormsAgreeWhereBothAreUsable)
{
  ASSERT_TRUE(SolidEffect::uses_pressure(0.45));
  const double mixed = squeeze_solid(0.45, "logarithmic", 8, 3).force, alone = squeeze_displacements(0.45, 8, 3).force;
  EXPECT_NEAR(alone / mixed, 1., 0.01);
  const double coarse = squeeze_displacements(0.45, 2, 3).force / squeeze_solid(0.45, "logarithmic", 2, 3).force;
  EXPECT_GT(coarse - 1., 2. * (alone / mixed - 1.)); // and their difference vanishes with the cells
}

TEST(NearlyIncompressible, BothLawsEndInTheIncompressibleSolid)
{
  const double limit = squeeze_solid(0.5, "logarithmic", 4, 2).force;
  EXPECT_NEAR(squeeze_solid(0.5, "quadratic", 4, 2).force / limit, 1., 1e-12);
  EXPECT_NEAR(squeeze_solid(0.5 - 1e-6, "quadratic", 4, 2).force / limit, 1., 1e-4);
  // J = 1 in the mean of J in one, of ln J in the other
  EXPECT_NEAR(squeeze_solid(0.5 - 1e-6, "logarithmic", 4, 2).force / limit, 1., 1e-2);
}
} // namespace
