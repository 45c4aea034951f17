// SPDX-License-Identifier: LGPL-2.1-or-later
// What is found does not depend on units, place, orientation or numbering. Energies to 1e-9, multipliers to 1e-7: the
// equations are the same, round-off and the order of sums are not.
#include "director_runs.h"
#include "droplet_runs.h"
#include "moved_scenes.h"

#include <pellicle/models/ridge_scene.h>
#include <pellicle/potentials/solids/solid_effect.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double energy_tolerance = 1e-9, multiplier_tolerance = 1e-7;

/** Energy and multipliers of an equilibrium, in the unit of energy given and internal units. */
struct Found
{
  double energy = 0.;
  std::vector<double> multipliers;
};

Found equilibrium(const SurfaceScene &scene, const double unit_of_energy = 1.)
{
  const Solved run(scene);
  EXPECT_TRUE(run.result.converged) << run.result.failure;
  return {run.quantity("total_energy") * unit_of_energy, run.model.equilibrium().state().multipliers};
}

void expect_same(const Found &found, const Found &expected)
{
  EXPECT_NEAR(found.energy, expected.energy, energy_tolerance * std::abs(expected.energy));
  ASSERT_EQ(found.multipliers.size(), expected.multipliers.size());
  for (std::size_t k = 0; k < expected.multipliers.size(); ++k)
    EXPECT_NEAR(found.multipliers[k], expected.multipliers[k], multiplier_tolerance * std::abs(expected.multipliers[k]))
        << "multiplier " << k;
}

/** Equilibria are asked for more exactly than usual: the multipliers of the two are compared to 1e-7. */
template <typename Scene>
Scene exact(Scene scene)
{
  scene.newton.tolerance = 1e-12;
  return scene;
}

VesicleScene prolate()
{
  return exact(vesicle("prolate", 0.85, 3, 1));
}

/** Free directors: position, directors and shear. */
DirectorScene tilted_vesicle()
{
  DirectorScene scene = director_scene("prolate", {"none", 3, 1}, 50., {"area constraint", "volume constraint"});
  scene.vesicle.reduced_volume = 0.85;
  return exact(std::move(scene));
}

DropletScene heavy_drop_in_space()
{
  return exact(heavy_drop(75., {"none", 3, 1}));
}

/** Stiff enough that all the load may come at once. */
RidgeScene ridge()
{
  RidgeScene scene;
  list_effects(scene, ridge_effects(), {"liquid surface", "volume constraint", "solid", "solid skins"}, {});
  scene.substrate.young   = 8.;
  scene.substrate.lateral = "sliding";
  scene.line.motion       = "free";
  scene.line.cell_size    = 0.05;
  scene.mesh.degree       = 2;
  scene.mesh.refinements  = 1;
  return exact(std::move(scene));
}

template <typename SceneMaker>
void expect_no_units(const SceneMaker &make)
{
  const Found expected = equilibrium(make());
  for (const auto &[length, energy] : {std::pair(1e-9, 1e-9), std::pair(1e9, 1e9), std::pair(1e-9, 1e9)})
  {
    SCOPED_TRACE("units " + std::to_string(length) + ", " + std::to_string(energy));
    auto scene = make();
    change_units(scene, length, energy);
    expect_same(equilibrium(scene, 1. / energy), expected);
  }
}

template <typename SceneMaker, typename Change>
void expect_unchanged(const SceneMaker &make, const Change &change)
{
  expect_same(equilibrium(Moved(make(), change)), equilibrium(make()));
}

TEST(Invariance, VesicleUnderUnits)
{
  expect_no_units(prolate);
}
TEST(Invariance, DirectorsUnderUnits)
{
  expect_no_units(tilted_vesicle);
}
TEST(Invariance, DropUnderUnits)
{
  expect_no_units(heavy_drop_in_space);
}
TEST(Invariance, RidgeUnderUnits)
{
  expect_no_units(ridge);
}

TEST(Invariance, VesicleUnderRotation)
{
  expect_unchanged(prolate, [](SurfaceDiscretization &mesh) { rotate(mesh, {0.6, 0., 0.8}, 1.1); });
}
TEST(Invariance, DirectorsUnderRotation)
{
  expect_unchanged(tilted_vesicle, [](SurfaceDiscretization &mesh) { rotate(mesh, {0., 0.6, 0.8}, 2.1); });
}
/** Gravity and the plane leave rotations about z. */
TEST(Invariance, DropUnderRotation)
{
  expect_unchanged(heavy_drop_in_space, [](SurfaceDiscretization &mesh) { rotate(mesh, {0., 0., 1.}, 0.4); });
}

TEST(Invariance, VesicleUnderTranslation)
{
  expect_unchanged(prolate, [](SurfaceDiscretization &mesh) { translate(mesh, {1000., -1000., 1000.}); });
}
TEST(Invariance, MeridianUnderTranslation)
{
  const auto meridian = [] { return exact(vesicle("prolate", 0.85, 3, 2, "axial")); };
  expect_unchanged(meridian, [](SurfaceDiscretization &mesh) { translate(mesh, {0., 0., 1000.}); });
}
TEST(Invariance, DirectorsUnderTranslation)
{
  expect_unchanged(tilted_vesicle, [](SurfaceDiscretization &mesh) { translate(mesh, {1000., -1000., 1000.}); });
}
/** Along the plane. */
TEST(Invariance, DropUnderTranslation)
{
  expect_unchanged(heavy_drop_in_space, [](SurfaceDiscretization &mesh) { translate(mesh, {1000., 0., 0.}); });
}
TEST(Invariance, RidgeUnderTranslation)
{
  expect_unchanged(ridge, [](SurfaceDiscretization &mesh) { translate(mesh, {0., 0., 1000.}); });
}

TEST(Invariance, VesicleUnderRenumbering)
{
  expect_unchanged(prolate, [](SurfaceDiscretization &mesh) { renumber(mesh); });
}
TEST(Invariance, DirectorsUnderRenumbering)
{
  expect_unchanged(tilted_vesicle, [](SurfaceDiscretization &mesh) { renumber(mesh); });
}
TEST(Invariance, DropUnderRenumbering)
{
  expect_unchanged(heavy_drop_in_space, [](SurfaceDiscretization &mesh) { renumber(mesh); });
}
TEST(Invariance, RidgeUnderRenumbering)
{
  expect_unchanged(ridge, [](SurfaceDiscretization &mesh) { renumber(mesh); });
}
} // namespace
