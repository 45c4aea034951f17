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
Scene &with_mesh(Scene &scene, const LevelMesh &mesh)
{
  scene.mesh.degree         = static_cast<int>(mesh.degree);
  scene.mesh.refinements    = static_cast<int>(mesh.refinements);
  scene.newton.initial_drag = 0.;
  return scene;
}

/** Solves on a coarse mesh and goes on to a finer one; returns the energy there. */
template <typename Scene>
double energy_after_few_iterations(const std::function<Scene()> &scene, const LevelMesh &coarse_mesh,
                                   const LevelMesh &fine_mesh, const int most_iterations, const std::string &what)
{
  Scene coarse = scene(), fine = scene();
  coarse.mesh.degree      = static_cast<int>(coarse_mesh.degree);
  coarse.mesh.refinements = static_cast<int>(coarse_mesh.refinements);
  const Solved solved(coarse);
  EXPECT_TRUE(solved.result.converged) << what << ": " << solved.result.failure;
  Continued continued(with_mesh(fine, fine_mesh), solved.model);
  EXPECT_TRUE(continued.is_possible) << what;
  continued.solve(most_iterations, what);
  return quantity(continued.model, "total_energy");
}

/** The same; and a solve on the finer mesh from its own start ends at the same energy, but for where nodes lie. */
template <typename Scene>
void expect_few_iterations(const std::function<Scene()> &scene, const LevelMesh &coarse_mesh,
                           const LevelMesh &fine_mesh, const int most_iterations, const double tolerance,
                           const std::string &what)
{
  const double energy = energy_after_few_iterations(scene, coarse_mesh, fine_mesh, most_iterations, what);
  Scene from_start    = scene();
  with_mesh(from_start, fine_mesh).newton.initial_drag = NewtonParameters().initial_drag;
  const Solved fresh(from_start);
  ASSERT_TRUE(fresh.result.converged) << what << ": " << fresh.result.failure;
  EXPECT_NEAR(energy / quantity(fresh.model, "total_energy"), 1., tolerance) << what;
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

// The volume is that of polynomials of degree 3k - 1, which the Gauss points of degree 2 integrate exactly; the area
// differs by the quadrature.
TEST(StateTransfer, ShapesKeepTheirVolume)
{
  const Solved solved(vesicle("prolate", 0.9, 2, 1));
  ASSERT_TRUE(solved.result.converged);
  for (const LevelMesh &mesh : {LevelMesh{2, 2}, {3, 1}, {4, 2}, {5, 1}})
  {
    VesicleScene scene = vesicle("prolate", 0.9, 2, 1);
    const Continued continued(with_mesh(scene, mesh), solved.model);
    ASSERT_TRUE(continued.is_possible);
    EXPECT_NEAR(quantity(continued.model, "volume") / solved.quantity("volume"), 1., 1e-13);
    EXPECT_NEAR(quantity(continued.model, "area") / solved.quantity("area"), 1., 1e-4);
    EXPECT_EQ(continued.model.equilibrium().state().multipliers, solved.model.equilibrium().state().multipliers);
  }
}

TEST(StateTransfer, Prolates)
{
  for (const char *symmetry : {"axial mirror", "axial"})
    for (const LevelMesh &fine : {LevelMesh{4, 2}, {3, 3}, {5, 2}})
      expect_few_iterations<VesicleScene>([&] { return vesicle("prolate", 0.9, 3, 2, symmetry); }, {3, 2}, fine, 3,
                                          1e-9, symmetry);
  // In space the vesicle may turn with respect to the mesh.
  for (const LevelMesh &fine : {LevelMesh{4, 1}, {3, 2}})
    expect_few_iterations<VesicleScene>([] { return vesicle("prolate", 0.9, 3, 1); }, {3, 1}, fine, 4, 1e-7,
                                        "in space");
}

TEST(StateTransfer, MembranesWithALine)
{
  const auto bud = []
  {
    VesicleScene scene =
        scene_with({"helfrich bending", "lipid domain", "line tension", "area constraint", "volume constraint"});
    scene.vesicle.start_shape                                = "prolate";
    scene.vesicle.reduced_volume                             = 0.9;
    scene.mesh.symmetry                                      = "axial";
    effect<LipidDomainEffect>(scene).parameters              = {0.15, 1., 1.};
    effect<LineTensionEffect>(scene).parameters.line_tension = 1.;
    return scene;
  };
  expect_few_iterations<VesicleScene>(bud, {3, 2}, {4, 2}, 4, 1e-8, "degree");
  expect_few_iterations<VesicleScene>(bud, {3, 2}, {3, 3}, 4, 1e-8, "refined");
}

// Where the moment jumps the line has two nodes at each place, and a conormal.
TEST(StateTransfer, MembranesThatAreSplit)
{
  const auto two_moduli = []
  {
    VesicleScene scene           = scene_with({"helfrich bending", "lipid domain", "line tension", "area constraint",
                                               "volume constraint", "gaussian curvature"});
    scene.vesicle.start_shape    = "prolate";
    scene.vesicle.reduced_volume = 0.9;
    scene.mesh.symmetry          = "axial";
    effect<LipidDomainEffect>(scene).parameters                         = {0.15, 1., 1.};
    effect<LineTensionEffect>(scene).parameters.line_tension            = 1.;
    effect<GaussianCurvatureEffect>(scene).parameters.domain_difference = 0.5;
    return scene;
  };
  const double energy = energy_after_few_iterations<VesicleScene>(two_moduli, {3, 2}, {4, 2}, 4, "degree");
  EXPECT_NEAR(energy_after_few_iterations<VesicleScene>(two_moduli, {3, 2}, {3, 3}, 4, "refined"), energy, 1e-7);
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
  expect_few_iterations<VesicleScene>(tether, {3, 2}, {4, 2}, 4, 1e-9, "degree");
  expect_few_iterations<VesicleScene>(tether, {3, 2}, {3, 3}, 5, 1e-9, "refined");
}

TEST(StateTransfer, Drops)
{
  const auto on_sphere = [](const char *symmetry)
  {
    DropletScene scene     = drop(60., {symmetry, 3, 1});
    scene.substrate.shape  = "sphere";
    scene.substrate.radius = 3.;
    return scene;
  };
  for (const LevelMesh &fine : {LevelMesh{4, 1}, {3, 2}})
  {
    expect_few_iterations<DropletScene>(
        [] {
          return heavy_drop(120., {"axial", 3, 1});
        },
        {3, 1}, fine, 3, 1e-9, "plane");
    expect_few_iterations<DropletScene>([&] { return on_sphere("axial"); }, {3, 1}, fine, 3, 1e-9, "sphere");
  }
  energy_after_few_iterations<DropletScene>([&] { return on_sphere("none"); }, {2, 1}, {3, 1}, 3, "sphere in space");
}

// Nodes that touch the plate are known from the start; at the edge of the contact others take part.
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
  expect_few_iterations<DropletScene>(whole_drop, {3, 2}, {3, 3}, 25, 1e-7, "does not wet");
}

TEST(StateTransfer, Directors)
{
  energy_after_few_iterations<DirectorScene>([] { return on_torus(0, 1.); }, {3, 0}, {4, 0}, 4, "tilted");
  energy_after_few_iterations<DirectorScene>([] { return on_torus(0, infinite); }, {3, 0}, {3, 1}, 4, "normal");
  expect_few_iterations<DirectorScene>(
      [] {
        return around_disc({"axial", 3, 1}, 0.3);
      },
      {3, 1}, {4, 2}, 4, 1e-6, "inclusion");
}

TEST(StateTransfer, Shells)
{
  for (const LevelMesh &fine : {LevelMesh{4, 1}, {3, 2}})
    energy_after_few_iterations<ShellScene>([] { return pinched_hemisphere(1., 3, 1); }, {3, 1}, fine, 5, "hemisphere");
}

// What stands at a pinned line depends on how it got there.
TEST(StateTransfer, PinnedLinesStartAnew)
{
  DropletScene pinned = drop(90., {"axial", 3, 1}, {"line pinning"}),
               finer  = drop(90., {"axial", 3, 2}, {"line pinning"});
  const Solved solved(pinned);
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  EXPECT_FALSE(Continued(finer, solved.model).is_possible);
}
} // namespace
