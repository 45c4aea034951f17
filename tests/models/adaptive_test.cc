// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a solution is local, meshes that follow it need fewer unknowns for the same error.
#include "adaptive_runs.h"

#include <pellicle/potentials/constraints/lipid_domain.h>
#include <pellicle/potentials/constraints/tether.h>

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** Bending energy of a spheroid whose axis along z is 1/10 of the others: all of it is at the rim. */
SceneAlongLoad flat_spheroid(const std::string &symmetry, const int degree, const int refinements)
{
  return [=](const double)
  {
    VesicleScene scene        = scene_with({"helfrich bending"});
    scene.vesicle.start_shape = "ellipsoid";
    scene.vesicle.semi_axes   = {1., 1., 0.1};
    scene.mesh.symmetry       = symmetry;
    scene.mesh.degree         = degree;
    scene.mesh.refinements    = refinements;
    return std::make_unique<VesicleScene>(std::move(scene));
  };
}

/** A tube pulled out of a membrane under tension by a disc of a fifth of its radius. */
SceneAlongLoad tether(const int degree, const int refinements)
{
  return [=](const double t)
  {
    VesicleScene scene     = scene_with({"helfrich bending", "tether"});
    scene.mesh.degree      = degree;
    scene.mesh.refinements = refinements;
    scene.mesh.symmetry    = "axial";
    TetherParameters &pull = effect<TetherEffect>(scene).parameters;
    pull.length            = 25. * t;
    pull.ring_radius       = 20.;
    pull.tip_radius        = 0.2;
    pull.tension           = 0.5;
    return std::make_unique<VesicleScene>(std::move(scene));
  };
}

/** A domain of a tenth of a vesicle, with line tension, that wants to be curved by C0. */
SceneAlongLoad bud(const int degree, const int refinements, const double C0)
{
  return [=](const double t)
  {
    VesicleScene scene           = scene_with({"helfrich bending", "lipid domain", "line tension", "area constraint"});
    scene.mesh.degree            = degree;
    scene.mesh.refinements       = refinements;
    scene.mesh.symmetry          = "axial";
    scene.vesicle.start_shape    = "ellipsoid";
    scene.vesicle.semi_axes      = {1., 1., 1.02};
    auto &domain                 = effect<LipidDomainEffect>(scene).parameters;
    domain.area_fraction         = 0.1;
    domain.bending_rigidity      = 1.;
    domain.spontaneous_curvature = C0 * t;
    return std::make_unique<VesicleScene>(std::move(scene));
  };
}

/** Unknowns that uniform meshes need for a relative error of the energy, over those of adapted ones. */
double gain(const SceneAlongLoad &coarse, const MeshFamily &uniform, const SceneAlongLoad &to_adapt,
            const MeshFamily &adaptive, const double error, const double exact)
{
  Levels all(coarse, uniform), some(to_adapt, adaptive);
  const double with_all = unknowns_for(error, exact, all.run()), with_some = unknowns_for(error, exact, some.run());
  EXPECT_LT(with_some, 1e9) << "the meshes that are adapted do not reach " << error;
  if (!some.iterations.empty())
  {
    EXPECT_LE(some.iterations.back(), 6) << "the state before is a poor start";
  }
  return with_all / with_some;
}

// In space, with hanging nodes: an edge of small radius all around. The energy from meridians of degree 5 (1e-12).
TEST(Adaptive, RimOfAFlatSpheroid)
{
  const double exact = Levels(flat_spheroid("axial mirror", 5, 7), {1, 1, 0., false}).run()[0].energy;
  EXPECT_GT(gain(flat_spheroid("none", 3, 1), {4, 1, 0., false}, flat_spheroid("none", 3, 1), {6, 1, 0.6, false}, 1e-4,
                 exact),
            3.);
}

// The neck of a bud: uniform meshes miss it until 128 cells. Energy: uniform meshes of 256 cells of degree 4 and
// adapted ones of 37 agree to 3e-10. Meshes are adapted from 16 cells on: what a load path on 8 arrives at may be too
// far off for the meshes after it, which then stay at another equilibrium, of energy 26.1765.
TEST(Adaptive, NeckOfABud)
{
  const double energy = 26.152890156;
  EXPECT_GT(gain(bud(4, 1, 7.4), {5, 16, 0., true}, bud(4, 2, 7.4), {5, 16, 0.6, true}, 1e-5, energy), 3.);
}

// Tip and tube of a tether of 25 tube radii, on meshes that are graded towards the tip from the start. Energy: uniform
// meshes of 256 cells of degree 4, whose last levels differ by 4e-11.
TEST(Adaptive, Tether)
{
  EXPECT_GT(gain(tether(4, 1), {4, 30, 0., true}, tether(4, 1), {7, 30, 0.6, true}, 1e-8, 771.7684580755), 2.);
}
} // namespace
