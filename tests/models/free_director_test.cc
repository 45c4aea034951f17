// SPDX-License-Identifier: LGPL-2.1-or-later
// Membranes with directors that are free to move: vesicles with tilt, cylinders under tension. K = 1.
#include "director_runs.h"

#include <pellicle/discretization/edge_loops.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

DirectorScene vesicle_with_tilt(const std::string &start_shape, const double reduced_volume, const DirectorMesh &mesh,
                                const double k_t)
{
  DirectorScene scene          = director_scene(start_shape, mesh, k_t, {"area constraint", "volume constraint"});
  scene.vesicle.reduced_volume = reduced_volume;
  return scene;
}

/** Of an independent axisymmetric solution with 96 to 112 spectral unknowns, to 1e-12. */
struct Vesicle
{
  const char *start_shape;
  double reduced_volume, k_t, energy, tilt_energy, sigma, P, polar_height;
};
const std::vector<Vesicle> prolates{
    {"prolate", 0.9, 10., 16.488156498235, 0.745760579954, -4.6154077815, -10.1245823114, 2.86189257826},
    {"prolate", 0.9, 100., 17.238878856334, 0.092688438466, -5.0643298631, -11.2376754479, 2.85802859583},
    {"prolate", 0.9, 1000., 17.323171072674, 0.009463093869, -5.1013677754, -11.3346993918, 2.85850633402},
    {"prolate", 0.9, infinite, 17.332645017521, 0., -5.1053676387, -11.3452614194, 2.85856795107}};
// The one at k_t = 10 has directors that lean by .41: far from a spheroid with normal ones.
const std::vector<Vesicle> oblates{
    {"oblate", 0.65, 100., 32.075226684926, 1.180518827045, -4.7750544343, -14.4034207106, 0.38720234804},
    {"biconcave", 0.65, 10., 25.097939656235, 5.126545251432, -3.2599373411, -8.7753225608, 0.43332532910}};

void expect_agreement(const Solved &solved, const Vesicle &v, const std::size_t iterations, const double tolerance)
{
  const std::string what = std::string(v.start_shape) + ", k_t = " + std::to_string(v.k_t);
  ASSERT_TRUE(solved.result.converged) << what << ": " << solved.result.failure;
  EXPECT_LE(solved.record.iterations.size(), iterations) << what;
  EXPECT_LT(relative_error(solved.quantity("total_energy"), v.energy), tolerance) << what;
  EXPECT_LT(relative_error(solved.quantity("tension"), v.sigma), 10. * tolerance) << what;
  EXPECT_LT(relative_error(solved.quantity("pressure"), v.P), 10. * tolerance) << what;
}

TEST(FreeDirectors, VesiclesOnMeridians)
{
  for (const auto *list : {&prolates, &oblates})
    for (const Vesicle &v : *list)
    {
      const Solved solved(vesicle_with_tilt(v.start_shape, v.reduced_volume, {"axial", 4, 3}, v.k_t));
      expect_agreement(solved, v, 8, 1e-7);
      const NodalVectors &x = solved.positions();
      EXPECT_NEAR(x[2] - x[x.size() - 1], v.polar_height, 1e-5 * v.polar_height) << v.k_t;
      expect_quadratic_tail(solved.record.iterations, 1e-2, 100., 1e-10);
    }
}

TEST(FreeDirectors, VesiclesInSpace)
{
  struct Case
  {
    double k_t;
    int refinements;
    double tolerance;
  };
  for (const Case &c : {Case{infinite, 2, 5e-5}, Case{100., 2, 5e-5}, Case{100., 3, 3e-6}})
  {
    const auto v = std::find_if(prolates.begin(), prolates.end(), [&](const Vesicle &p) { return p.k_t == c.k_t; });
    const Solved solved(vesicle_with_tilt(v->start_shape, v->reduced_volume, {"none", 3, c.refinements}, c.k_t));
    expect_agreement(solved, *v, 8, c.tolerance);
  }
}

// With directors that stay normal it is the model of Helfrich, but for the null term 4 pi K.
TEST(FreeDirectors, HelfrichInTheLimit)
{
  const Solved with_directors(vesicle_with_tilt("prolate", 0.9, {"axial", 4, 2}, infinite)),
      without(vesicle("prolate", 0.9, 4, 2, "axial"));
  ASSERT_TRUE(with_directors.result.converged && without.result.converged);
  EXPECT_NEAR(with_directors.quantity("total_energy") + 4. * pi, without.quantity("bending_energy"), 1e-6);
  EXPECT_NEAR(with_directors.quantity("pressure"), without.quantity("pressure"), 1e-5);
}

/** Tube about z of radius `radius` at its ends, under the tension for which that of the equilibrium is 1. */
DirectorScene tube_under_tension(const double radius, const double length, const DirectorMesh &mesh, const double k_t)
{
  DirectorScene scene                                    = director_scene("tube", mesh, k_t, {"surface tension"});
  scene.vesicle.tube_ratio                               = length / radius;
  scene.vesicle.area                                     = 2. * pi * radius * length;
  scene.vesicle.rim                                      = "hinged";
  effect<SurfaceTensionEffect>(scene).parameters.tension = 0.5;
  return scene;
}

// R = sqrt(K/(2 sigma)), energy per length 2 pi sqrt(2 K sigma), where the ends are far.
TEST(FreeDirectors, RadiusOfCylinder)
{
  const double length = 40.;
  const Solved solved(tube_under_tension(1.05, length, {"axial", 4, 4}, 20.));
  ASSERT_TRUE(solved.result.converged) << solved.result.failure;
  const NodalVectors &x = solved.positions();
  const double unit     = solved.model.scales().length;
  double middle = 0., nearest = length;
  for (std::size_t I = 0; 3 * I < x.size(); ++I)
    if (std::abs(x[3 * I + 2]) < nearest)
    {
      nearest = std::abs(x[3 * I + 2]);
      middle  = unit * x[3 * I];
    }
  EXPECT_NEAR(middle, 1., 1e-5);
  const Solved exact(tube_under_tension(1., length, {"axial", 4, 4}, 20.));
  ASSERT_TRUE(exact.result.converged);
  EXPECT_LT(relative_error(exact.quantity("total_energy"), 2. * pi * length), 1e-10);
}

// Directors along the normals of a held cylinder of that radius: tilt cos(n pi z/L) along the axis has the eigenvalue
// k_t - 2 sigma + K (n pi/L)^2, tilt across it and that with nodal lines along the axis are stable.
TEST(FreeDirectors, AxialTiltOnCylinder)
{
  for (const DirectorMesh &mesh : {DirectorMesh{"axial", 4, 2}, DirectorMesh{"none", 3, 1}})
    for (const double k_t : {0.5, 0.95, 1.05})
    {
      const double length  = 6.;
      DirectorScene scene  = tube_under_tension(1., length, mesh, k_t);
      scene.carrier.motion = "held";
      scene.analyses       = {"stability"};
      int unstable         = 0;
      while (k_t - 1. + std::pow(unstable * pi / length, 2) < 0.)
        ++unstable;
      const Solved solved(scene);
      ASSERT_TRUE(solved.result.converged) << mesh.symmetry << ", k_t = " << k_t << ": " << solved.result.failure;
      EXPECT_EQ(solved.negative_eigenvalues(), unstable) << mesh.symmetry << ", k_t = " << k_t;
    }
}

// The threshold k_t = 2 sigma is the same where the shape is free.
TEST(FreeDirectors, AxialTiltOnFreeCylinder)
{
  for (const double k_t : {0.95, 1.05})
  {
    DirectorScene scene = tube_under_tension(1., 6., {"axial", 4, 3}, k_t);
    scene.analyses      = {"stability"};
    const Solved solved(scene);
    ASSERT_TRUE(solved.result.converged) << "k_t = " << k_t << ": " << solved.result.failure;
    EXPECT_EQ(solved.negative_eigenvalues(), k_t < 1. ? 1 : 0) << "k_t = " << k_t;
  }
}
} // namespace
