// SPDX-License-Identifier: LGPL-2.1-or-later
// States carried over to finer meshes and other degrees: exact where they can be represented, and close enough to the
// equilibrium there that Newton's method needs a few steps only.
#include "director_runs.h"
#include "droplet_runs.h"
#include "shell_runs.h"

#include <pellicle/assembly/edge_frames.h>
#include <pellicle/discretization/lagrange_line.h>
#include <pellicle/discretization/mesh_transfer.h>
#include <pellicle/potentials/constraints/lipid_domain.h>
#include <pellicle/potentials/constraints/tether.h>
#include <pellicle/potentials/edges/gaussian_curvature.h>
#include <pellicle/potentials/edges/line_tension.h>
#include <pellicle/potentials/wetting/line_pinning.h>

#include <gtest/gtest.h>

#include <memory>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** A model on another mesh that starts from a solved one. */
class Continued
{
public:
  Continued(const SurfaceScene &scene, const SurfaceModel &solved)
      : model(scene, communicator, timing)
      , is_possible(model.start_from(solved))
  {
  }

  /** Solves, and expects few iterations. */
  void solve(const int most_iterations, const std::string &what)
  {
    result = model.solve(1, record);
    ASSERT_TRUE(result.converged) << what << ": " << result.failure;
    EXPECT_LE(result.iterations, most_iterations) << what;
  }

  Communicator communicator;
  Timing timing;
  Record record;
  SurfaceModel model;
  bool is_possible;
  StepResult result;
};

template <typename Scene>
Scene &with_mesh(Scene &scene, const int degree, const int refinements)
{
  scene.mesh.degree         = degree;
  scene.mesh.refinements    = refinements;
  scene.newton.initial_drag = 0.;
  return scene;
}

/** Solves on a coarse mesh, goes on to a finer one, and compares with a solve there from the start. */
template <typename Scene>
void expect_few_iterations(const std::function<Scene()> &scene, const std::array<int, 2> &coarse_mesh,
                           const std::array<int, 2> &fine_mesh, const int most_iterations, const std::string &what)
{
  SCOPED_TRACE(what);
  Scene coarse = scene(), fine = scene(), from_start = scene();
  coarse.mesh.degree      = coarse_mesh[0];
  coarse.mesh.refinements = coarse_mesh[1];
  const Solved solved(coarse);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  Continued continued(with_mesh(fine, fine_mesh[0], fine_mesh[1]), solved.model);
  ASSERT_TRUE(continued.is_possible);
  continued.solve(most_iterations, what);
  from_start.mesh = fine.mesh;
  const Solved fresh(from_start);
  ASSERT_TRUE(fresh.result.converged) << fresh.result.failure;
  const double energy = quantity(fresh.model, "total_energy");
  EXPECT_NEAR(quantity(continued.model, "total_energy"), energy, 1e-9 * std::abs(energy));
}

/** Values at the nodes of a polynomial of degree k in each coordinate of a patch. */
NodalVectors polynomial_of_patches(const SurfaceDiscretization &mesh, const unsigned int k)
{
  const std::vector<double> line = LagrangeLine(mesh.degree).points();
  NodalVectors values(3 * mesh.n_nodes);
  for (std::size_t cell = 0; cell < mesh.n_cells; ++cell)
    for (unsigned int i = 0; i < mesh.n_local(); ++i)
    {
      const auto &[patch, u0, v0, size] = mesh.cell_places[cell];
      const double u = u0 + size * line[i % line.size()], v = v0 + size * line[i / line.size()];
      set_vector_at(values, mesh.cell_nodes[cell * mesh.n_local() + i],
                    {std::pow(u, k) + v, std::pow(u * v, k) - u, 1. + std::pow(v, k)});
    }
  return values;
}

// On a plate, which is one patch.
TEST(StateTransfer, PolynomialsAreCarriedOverExactly)
{
  for (const unsigned int k : {2u, 3u, 5u})
    for (const int refinements : {1, 2, 3})
      for (const unsigned int degree : {k, 5u})
      {
        const ShellShape coarse{"plate", 1., 1., 1., 0., k, 1},
            fine{"plate", 1., 1., 1., 0., degree, static_cast<unsigned int>(refinements)};
        const SurfaceDiscretization a = shell_mesh(coarse), b = shell_mesh(fine);
        ASSERT_TRUE(MeshTransfer::is_possible(a, b));
        EXPECT_EQ(MeshTransfer::is_possible(b, a), refinements == 1);
        const NodalVectors values = MeshTransfer(a, b)(polynomial_of_patches(a, k));
        const NodalVectors exact  = polynomial_of_patches(b, k);
        for (std::size_t i = 0; i < values.size(); ++i)
          ASSERT_NEAR(values[i], exact[i], 1e-13) << k << ' ' << refinements << ' ' << degree;
      }
}

// The volume is that of polynomials of degree 3k - 1, which the Gauss points of degree 2 integrate exactly; all other
// measures differ by their quadrature, which the degree of the fine mesh makes small.
TEST(StateTransfer, ShapesKeepTheirVolumeAndEnergy)
{
  const Solved solved(vesicle("prolate", 0.9, 2, 1));
  ASSERT_TRUE(solved.result.converged);
  for (const auto &[degree, refinements] : {std::pair{2, 2}, {3, 1}, {4, 2}, {5, 1}})
  {
    VesicleScene scene = vesicle("prolate", 0.9, 2, 1);
    const Continued continued(with_mesh(scene, degree, refinements), solved.model);
    ASSERT_TRUE(continued.is_possible);
    EXPECT_NEAR(quantity(continued.model, "volume") / solved.quantity("volume"), 1., 1e-13);
    EXPECT_NEAR(quantity(continued.model, "area") / solved.quantity("area"), 1., 1e-4);
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_EQ(continued.model.equilibrium().state().multipliers[k],
                solved.model.equilibrium().state().multipliers[k]);
  }
}

TEST(StateTransfer, ProlatesNeedThreeIterations)
{
  for (const char *symmetry : {"axial mirror", "axial", "none"})
    for (const std::array<int, 2> &fine : {std::array<int, 2>{{4, 1}}, {{3, 2}}, {{5, 1}}})
      expect_few_iterations<VesicleScene>([&] { return vesicle("prolate", 0.9, 3, 1, symmetry); }, {{3, 1}}, fine, 3,
                                          symmetry + std::string(" ") + std::to_string(fine[0]));
}

TEST(StateTransfer, ClosedMembranesWithLines)
{
  const auto bud = [](const double difference)
  {
    std::vector<std::string> effects{"helfrich bending", "lipid domain", "line tension", "area constraint",
                                     "volume constraint"};
    if (difference != 0.)
      effects.push_back("gaussian curvature");
    VesicleScene scene                                       = scene_with(effects);
    scene.vesicle.start_shape                                = "prolate";
    scene.vesicle.reduced_volume                             = 0.9;
    scene.mesh.symmetry                                      = "axial";
    effect<LipidDomainEffect>(scene).parameters              = {0.15, 1., 1.};
    effect<LineTensionEffect>(scene).parameters.line_tension = 1.;
    if (difference != 0.)
      effect<GaussianCurvatureEffect>(scene).parameters.domain_difference = difference;
    return scene;
  };
  for (const double difference : {0., 0.5})
    for (const std::array<int, 2> &fine : {std::array<int, 2>{{4, 2}}, {{3, 3}}})
      expect_few_iterations<VesicleScene>([&] { return bud(difference); }, {{3, 2}}, fine, 4,
                                          "domain, moduli differ by " + std::to_string(difference));
}

// The tip is a rigid disc of clamped nodes with one unknown.
TEST(StateTransfer, Tethers)
{
  const auto tether = []
  {
    VesicleScene scene                            = scene_with({"helfrich bending", "tether"});
    scene.mesh.symmetry                           = "axial";
    effect<TetherEffect>(scene).parameters.length = 2.;
    return scene;
  };
  expect_few_iterations<VesicleScene>(tether, {{3, 2}}, {{4, 2}}, 4, "degree");
  expect_few_iterations<VesicleScene>(tether, {{3, 2}}, {{3, 3}}, 5, "refined");
}

TEST(StateTransfer, Drops)
{
  for (const char *symmetry : {"axial", "none"})
    for (const std::array<int, 2> &fine : {std::array<int, 2>{{4, 1}}, {{3, 2}}})
    {
      expect_few_iterations<DropletScene>(
          [&] {
            return heavy_drop(120., {symmetry, 3, 1});
          },
          {{3, 1}}, fine, 3, symmetry + std::string(" on a plane"));
      const auto on_sphere = [&]
      {
        DropletScene scene     = drop(60., {symmetry, 3, 1});
        scene.substrate.shape  = "sphere";
        scene.substrate.radius = 3.;
        return scene;
      };
      expect_few_iterations<DropletScene>(on_sphere, {{3, 1}}, fine, 3, symmetry + std::string(" on a sphere"));
    }
}

TEST(StateTransfer, ContactIsTakenOver)
{
  const auto whole_drop = []
  {
    DropletScene scene =
        make_droplet_scene(droplet_effects(), {"liquid surface", "volume constraint", "gravity", "contact"}, {});
    scene.droplet.volume        = reference_volume;
    scene.droplet.contact_angle = 180.;
    scene.droplet.base          = "membrane";
    scene.droplet.bond_number   = unit_bond_number;
    scene.mesh.symmetry         = "axial";
    return scene;
  };
  expect_few_iterations<DropletScene>(whole_drop, {{3, 2}}, {{3, 3}}, 25, "does not wet");
}

TEST(StateTransfer, Directors)
{
  for (const double k_t : {1., infinite})
    for (const std::array<int, 2> &fine : {std::array<int, 2>{{4, 1}}, {{3, 2}}})
      expect_few_iterations<DirectorScene>([&] { return on_torus(1, k_t); }, {{3, 1}}, fine, 4,
                                           "torus, tilt modulus " + std::to_string(k_t));
  expect_few_iterations<DirectorScene>(
      [] {
        return around_disc({"axial", 3, 1}, 0.3);
      },
      {{3, 1}}, {{4, 2}}, 4, "inclusion");
}

TEST(StateTransfer, Shells)
{
  expect_few_iterations<ShellScene>([] { return pinched_hemisphere(1., 3, 2); }, {{3, 2}}, {{4, 2}}, 4, "hemisphere");
  expect_few_iterations<ShellScene>([] { return pinched_hemisphere(1., 3, 2); }, {{3, 2}}, {{3, 3}}, 5, "hemisphere");
}

// What stands at a pinned line depends on how it got there, and ridges have meshes of their own on each level.
TEST(StateTransfer, OthersStartAnew)
{
  DropletScene pinned = drop(90., {"axial", 3, 1}, {"line pinning"}),
               finer  = drop(90., {"axial", 3, 2}, {"line pinning"});
  const Solved solved(pinned);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  EXPECT_FALSE(Continued(finer, solved.model).is_possible);
}
} // namespace
