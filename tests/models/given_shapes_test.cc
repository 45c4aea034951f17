// SPDX-License-Identifier: LGPL-2.1-or-later
// The moment eliminated on shapes whose curvature is known in closed form: bending energies and curvatures.
#include "equilibrium_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** Nothing is solved but the elimination of the moment. C0 = 0 where curvatures are asked for. */
class GivenShape
{
public:
  explicit GivenShape(const VesicleScene &scene)
      : model(scene, communicator, timing)
  {
  }

  double energy() const { return model.equilibrium().energy(); }

  /** L2 norm over the surface, relative to that of the exact function, of the error of -H = P . n/(2 kappa). Points
   * in the unit of the shape. */
  double curvature_error(const std::function<double(const Vector3<double> &)> &exact_outward) const
  {
    const SurfaceDiscretization &mesh = model.mesh();
    const ShapeTables &tables         = mesh.tables;
    const FieldValues &fields         = model.equilibrium().state().fields;
    const double length               = model.scales().length;
    std::vector<double> x(18 * tables.n_points), P(18 * tables.n_points);
    double error = 0., size = 0.;
    for (std::size_t cell = 0; cell < mesh.n_cells; ++cell)
    {
      const std::size_t *nodes = &mesh.cell_nodes[cell * tables.n_nodes];
      evaluate_field(tables, nodes, fields[0], 3, x.data());
      evaluate_field(tables, nodes, fields[model.equilibrium().layout().index("moment")], 1, P.data());
      for (unsigned int q = 0; q < tables.n_points; ++q)
      {
        const double *xq = &x[18 * q], *Pq = &P[18 * q];
        const Vector3<double> N = cross(Vector3<double>(xq[3], xq[4], xq[5]), Vector3<double>(xq[6], xq[7], xq[8]));
        const double dA         = tables.weights[q] * norm(N);
        const double H_out      = 0.5 * (dot(Vector3<double>(Pq[0], Pq[1], Pq[2]), N) / norm(N) / length);
        const double wanted     = exact_outward(length * Vector3<double>(xq[0], xq[1], xq[2]));
        error += dA * (H_out - wanted) * (H_out - wanted);
        size += dA * wanted * wanted;
      }
    }
    return std::sqrt(error / size);
  }

private:
  Communicator communicator;
  Timing timing;
  SurfaceModel model;
};

VesicleScene bending_only(const std::string &shape, const int degree, const int refinements)
{
  VesicleScene scene        = scene_with({"helfrich bending"});
  scene.vesicle.start_shape = shape;
  scene.vesicle.semi_axes   = {1., 1., 1.};
  scene.mesh.degree         = degree;
  scene.mesh.refinements    = refinements;
  return scene;
}

VesicleScene spheroid(const int degree, const int refinements)
{
  VesicleScene scene      = bending_only("ellipsoid", degree, refinements);
  scene.vesicle.semi_axes = {0.5, 0.5, 1.};
  scene.vesicle.area      = 5.369608831971;
  return scene;
}
constexpr double spheroid_energy = 30.903213288654;

VesicleScene biconcave(const int degree, const int refinements)
{
  VesicleScene scene = bending_only("biconcave", degree, refinements);
  scene.vesicle.area = 8.314387691448;
  return scene;
}
constexpr double biconcave_energy = 47.489731324552;

double of_unit_sphere(const Vector3<double> & /*x*/)
{
  return 1.;
}

/** Half the divergence of g/|g|, g = (x/a^2, y/b^2, z/c^2). */
double of_spheroid(const Vector3<double> &x)
{
  const Vector3<double> g(4. * x[0], 4. * x[1], x[2]);
  const double along = (4. * g[0] * g[0] + 4. * g[1] * g[1] + g[2] * g[2]) / dot(g, g);
  return 0.5 * (9. - along) / norm(g);
}

/** From the meridian (r, z) = (sin p, h(sin^2 p) cos p): sum of the principal curvatures
 * (z' r'' - r' z'')/s^3 and -z'/(r s), s the speed. */
double of_biconcave(const Vector3<double> &x)
{
  const double r = std::hypot(x[0], x[1]);
  const auto h   = [](const double t) { return 0.1242 + t * (0.8012 - 0.4492 * t); };
  const double p = std::atan2(r, x[2] / h(r * r)), s = std::sin(p), c = std::cos(p);
  const double h0 = h(s * s), h1 = 0.8012 - 2. * 0.4492 * s * s, h2 = -2. * 0.4492;
  const double dr = c, ddr = -s, dz = 2. * s * c * c * h1 - h0 * s;
  const double ddz =
      2. * (c * c * c - 2. * s * s * c) * h1 + 4. * s * s * c * c * c * h2 - 2. * s * s * c * h1 - h0 * c;
  const double speed = std::hypot(dr, dz);
  return 0.5 * ((dz * ddr - dr * ddz) / std::pow(speed, 3) + (h0 - 2. * c * c * h1) / speed);
}

TEST(GivenShapes, EnergyAndCurvatureOfASphere)
{
  const GivenShape sphere(bending_only("ellipsoid", 3, 3));
  EXPECT_NEAR(sphere.energy() / (8. * pi), 1., 1e-8);
  EXPECT_LE(sphere.curvature_error(of_unit_sphere), 5e-5);
}

TEST(GivenShapes, EnergyAndCurvatureOfASpheroid)
{
  const GivenShape shape(spheroid(3, 3));
  EXPECT_NEAR(shape.energy() / spheroid_energy, 1., 1e-7);
  EXPECT_LE(shape.curvature_error(of_spheroid), 1e-4);
}

TEST(GivenShapes, EnergyAndCurvatureOfTheBiconcaveDisc)
{
  const GivenShape shape(biconcave(3, 3));
  EXPECT_NEAR(shape.energy() / biconcave_energy, 1., 3e-6);
  EXPECT_LE(shape.curvature_error(of_biconcave), 6e-4);
}

TEST(GivenShapes, OrderOfTheCurvature)
{
  for (int k = 2; k <= 4; ++k)
  {
    const double coarse = GivenShape(bending_only("ellipsoid", k, 2)).curvature_error(of_unit_sphere);
    const double fine   = GivenShape(bending_only("ellipsoid", k, 3)).curvature_error(of_unit_sphere);
    EXPECT_GE(std::log2(coarse / fine), k - 0.2) << "degree " << k;
  }
}

TEST(GivenShapes, SpontaneousCurvatureOfEitherSign)
{
  for (const std::string symmetry : {"none", "axial", "axial mirror"})
    for (const double C0 : {1., -1.})
    {
      VesicleScene scene                                                    = bending_only("ellipsoid", 3, 3);
      scene.mesh.symmetry                                                   = symmetry;
      effect<HelfrichBendingEffect>(scene).parameters.spontaneous_curvature = C0;
      const double exact                                                    = C0 > 0. ? 2. * pi : 18. * pi;
      EXPECT_NEAR(GivenShape(scene).energy() / exact, 1., 1e-7) << symmetry << ", C0 = " << C0;
    }
}

// (kappa/2) integral of (2H)^2 = 4 pi^2 kappa at R/r = sqrt(2), Willmore's minimum.
TEST(GivenShapes, CliffordTorus)
{
  double errors[2];
  for (int level = 0; level < 2; ++level)
    errors[level] = std::abs(GivenShape(bending_only("torus", 3, 2 + level)).energy() / (4. * pi * pi) - 1.);
  EXPECT_LT(errors[1], 1e-6);
  EXPECT_GT(std::log2(errors[0] / errors[1]), 4.);
}

TEST(GivenShapes, MeridiansGiveTheSame)
{
  for (const std::string symmetry : {"axial", "axial mirror"})
  {
    VesicleScene sphere = bending_only("ellipsoid", 4, 4), ellipsoid = spheroid(4, 4), disc = biconcave(4, 4);
    for (VesicleScene *scene : {&sphere, &ellipsoid, &disc})
      scene->mesh.symmetry = symmetry;
    const GivenShape s(sphere), e(ellipsoid), d(disc);
    EXPECT_NEAR(s.energy() / (8. * pi), 1., 1e-13) << symmetry;
    EXPECT_NEAR(e.energy() / spheroid_energy, 1., 1e-12) << symmetry;
    EXPECT_NEAR(d.energy() / biconcave_energy, 1., 1e-11) << symmetry;
    EXPECT_LE(s.curvature_error(of_unit_sphere), 1e-5) << symmetry;
    EXPECT_LE(e.curvature_error(of_spheroid), 1e-5) << symmetry;
    EXPECT_LE(d.curvature_error(of_biconcave), 1e-4) << symmetry;
  }
}
} // namespace
