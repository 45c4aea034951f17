// SPDX-License-Identifier: LGPL-2.1-or-later
// Densities of directors on surfaces where their values are known in closed form.
#include "moving_directors.h"

#include <pellicle/base/constants.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/director/director_gradient.h>
#include <pellicle/potentials/director/in_plane_directors.h>
#include <pellicle/potentials/director/spontaneous_director_curvature.h>
#include <pellicle/potentials/director/tilt_energy.h>

#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr DirectorLaw law{2.3, 1.4, -0.6};

template <typename Density>
double value(const Density &density, const std::array<Vector3<double>, 6> &slots)
{
  return evaluate(DensityPotential<Density>("test", density), stacked(slots)).value[0];
}

double null_value(const std::array<Vector3<double>, 6> &slots)
{
  PointInputs<double, 1> inputs;
  inputs[0].slots = {slots[3], slots[4], slots[5]};
  return NullLagrangian{law.null_modulus()}.density(inputs, {});
}

/** Energies of a sphere of radius R whose directors are its normals turned about z by an angle. */
struct Sphere
{
  double tilt = 0., gradient = 0., null = 0., curvature = 0.;

  Sphere(const double R, const double angle, const double C0)
  {
    // Gauss points in z make the integrals below exact, which are polynomials of z.
    constexpr double z_gauss[3] = {-0.7745966692414834, 0., 0.7745966692414834},
                     w_gauss[3] = {5. / 9., 8. / 9., 5. / 9.};
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turn = [&](const Vector3<double> &n)
    { return Vector3<double>(c * n[0] - s * n[1], s * n[0] + c * n[1], n[2]); };
    constexpr unsigned int n_azimuth = 8;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < n_azimuth; ++j)
      {
        const double z = z_gauss[i], rho = std::sqrt(1. - z * z), phi = 2. * pi * j / n_azimuth,
                     weight = w_gauss[i] * 2. * pi / n_azimuth;
        const Vector3<double> n(rho * std::cos(phi), rho * std::sin(phi), z), n_phi(-n[1], n[0], 0.),
            n_z(-z * n[0] / (rho * rho), -z * n[1] / (rho * rho), 1.);
        const std::array<Vector3<double>, 6> slots{R * n, R * n_phi, R * n_z, turn(n), turn(n_phi), turn(n_z)};
        tilt += weight * value(TiltEnergy{law.tilt_modulus}, slots);
        gradient += weight * value(DirectorGradientEnergy{law.bending_modulus}, slots);
        null += weight * null_value(slots);
        curvature += weight * value(SpontaneousDirectorCurvature::of(law, C0), slots);
      }
  }
};

TEST(DirectorEnergies, SphereWithNormalDirectors)
{
  const double K = law.bending_modulus, kappa_G = law.gaussian_modulus;
  for (const double R : {0.7, 2.})
  {
    const double C0 = 1.3;
    const Sphere sphere(R, 0., C0);
    EXPECT_NEAR(sphere.tilt, 0., 1e-13);
    EXPECT_NEAR(sphere.gradient, 4. * pi * K, 1e-12);
    EXPECT_NEAR(sphere.null, 4. * pi * (K + kappa_G), 1e-12);
    // All together: Helfrich, and 2 k_1 eps_1 B^2/K per area.
    const double B = law.isotropic_curvature(C0), eps_1 = -0.5 * kappa_G;
    const double helfrich = 4. * pi * R * R * 0.5 * K * std::pow(C0 - 2. / R, 2) + 4. * pi * kappa_G;
    EXPECT_NEAR(sphere.gradient + sphere.null + sphere.curvature,
                helfrich + 4. * pi * R * R * 2. * law.k_1() * eps_1 * B * B / K, 1e-12);
  }
}

// A turn about z leaves |grad O| and the degree, and O . n = c + (1 - c) z^2 with c the cosine of the angle.
TEST(DirectorEnergies, SphereWithTurnedDirectors)
{
  const double angle = 0.8, c = std::cos(angle), R = 1.7;
  const Sphere sphere(R, angle, 0.);
  const double mean_square = c * c + 2. * c * (1. - c) / 3. + std::pow(1. - c, 2) / 5.;
  EXPECT_NEAR(sphere.tilt, 0.5 * law.tilt_modulus * 4. * pi * R * R * (1. - mean_square), 1e-12);
  EXPECT_NEAR(sphere.gradient, 4. * pi * law.bending_modulus, 1e-12);
  EXPECT_NEAR(sphere.null, 4. * pi * law.null_modulus(), 1e-12);
  EXPECT_EQ(sphere.curvature, 0.);
}

// Plane wave on the plane: O = (sin f, 0, cos f), f(x) with slope g.
TEST(DirectorEnergies, WaveOnThePlane)
{
  const double f = 0.6, g = 0.35, C0 = 0.9, B = law.isotropic_curvature(C0);
  const double s = std::sin(f), c = std::cos(f);
  // Skew coordinates: x = u + v/2, y = 2 v.
  const std::array<Vector3<double>, 6> slots{
      Vector3<double>(0.3, 0.1, 0.),  {1., 0., 0.}, {0.5, 2., 0.}, {s, 0., c}, {g * c, 0., -g * s},
      {0.5 * g * c, 0., -0.5 * g * s}};
  const double J = 2.;
  EXPECT_NEAR(value(TiltEnergy{law.tilt_modulus}, slots), J * 0.5 * law.tilt_modulus * s * s, 1e-14);
  EXPECT_NEAR(value(NormalDirectorEnergy{law.tilt_modulus}, slots), J * 0.5 * law.tilt_modulus * c * c, 1e-14);
  EXPECT_NEAR(value(DirectorGradientEnergy{law.bending_modulus}, slots), J * 0.5 * law.bending_modulus * g * g, 1e-14);
  EXPECT_NEAR(null_value(slots), 0., 1e-14);
  const double two_mu_1 = law.bending_modulus, two_mu_2 = law.null_modulus();
  EXPECT_NEAR(value(SpontaneousDirectorCurvature::of(law, C0), slots),
              J * (two_mu_1 * (B * g * c + 0.5 * B * B * (2. - s * s)) + two_mu_2 * (B * g + B * B * c)), 1e-14);
}

/** The same through P_a = d,a + b_a, b_a = B (I - d d) a_a, from the definition (43). */
TEST(DirectorEnergies, SpontaneousCurvatureIsThatOfItsVectors)
{
  const double C0 = 0.9, B = law.isotropic_curvature(C0), mu_1 = 0.5 * law.bending_modulus,
               mu_2 = 0.5 * law.null_modulus();
  over_torus(3,
             [&](const double u, const double v, const double)
             {
               const Jet x = jet(MovingTorus(), u, v, 0.1), O = jet(MovingDirectors(), u, v, 0.1);
               const TangentPlane<double> p(x.d[0], x.d[1]);
               const auto energy = [&](const double B_)
               {
                 FirstDerivatives<double> P;
                 for (unsigned int a = 0; a < 2; ++a)
                   P[a] = O.d[a] + B_ * (p.base[a] - dot(O.value, p.base[a]) * O.value);
                 return mu_1 * p.jacobian * gradient_product(p, P, P) + 2. * mu_2 * dot(cross(P[0], P[1]), O.value);
               };
               // Of any length: the interpolation is normalised.
               const double w = 0.9, w_1 = 0.2, w_2 = -0.1;
               const std::array<Vector3<double>, 6> slots{
                   x.value, x.d[0], x.d[1], w * O.value, w * O.d[0] + w_1 * O.value, w * O.d[1] + w_2 * O.value};
               EXPECT_NEAR(value(SpontaneousDirectorCurvature::of(law, C0), slots), energy(B) - energy(0.), 1e-13);
             });
}

// At O = n: -4 k_1 B H + 2 k_1 B^2, and with the gradient's and the null term Helfrich's energy and a constant.
TEST(DirectorEnergies, NormalDirectorsAreTheHelfrichModel)
{
  const double C0 = -0.8, B = law.isotropic_curvature(C0), K = law.bending_modulus, eps_1 = -0.5 * law.gaussian_modulus;
  EXPECT_NEAR(C0, -2. * law.k_1() * B / K, 1e-15);
  over_torus(3,
             [&](const double u, const double v, const double)
             {
               const Jet x = jet(MovingTorus(), u, v, 0.1);
               const SurfacePoint<double> p(x.d[0], x.d[1], x.dd[0][0], x.dd[0][1], x.dd[1][1]);
               std::array<Vector3<double>, 6> slots{x.value, x.d[0], x.d[1], p.normal};
               for (unsigned int a = 0; a < 2; ++a)
                 slots[4 + a] = -p.mixed_curvature[0][a] * p.base[0] - p.mixed_curvature[1][a] * p.base[1];
               const double H = p.mean_curvature, J = p.jacobian,
                            curvature = value(SpontaneousDirectorCurvature::of(law, C0), slots);
               EXPECT_NEAR(curvature, J * (-4. * law.k_1() * B * H + 2. * law.k_1() * B * B), 1e-12);
               const double sum = curvature + value(DirectorGradientEnergy{K}, slots) + null_value(slots);
               EXPECT_NEAR(sum,
                           J * (0.5 * K * std::pow(2. * H + C0, 2) + law.gaussian_modulus * p.gauss_curvature +
                                2. * law.k_1() * eps_1 * B * B / K),
                           1e-12);
             });
}

/** The mixed form at a point: its gradient in q, and its value. */
struct Mixed
{
  PointSums sums;

  Mixed(const double k_t, const double k_0, const Vector3<double> &O, const Vector3<double> &q)
  {
    const DensityPotential<MixedTiltEnergy> potential(
        "mixed", MixedTiltEnergy{k_t, std::make_shared<const std::vector<double>>(1, k_0)});
    const std::vector<double> inputs{0., 0., 0., 1., 0., 0.2, 0.5, 2., 0., O[0], O[1], O[2], q[0], q[1], q[2]};
    const unsigned int offsets[3] = {0, 9, 12};
    sums.reset(1, 15, Order::gradient);
    potential.add({0, 1, 15, inputs.data()}, offsets, 1., Order::gradient, sums);
  }
};

// Its maximum over q is the energy of tilt, whatever the part k_0.
TEST(DirectorEnergies, MixedTiltIsTheEnergyOfTilt)
{
  const Vector3<double> O = unit(Vector3<double>(0.3, -0.2, 0.9));
  const TangentPlane<double> p({1., 0., 0.2}, {0.5, 2., 0.});
  const Vector3<double> tilt = tangential_part(p, O);
  for (const double k_0 : {0.1, 1.1})
  {
    const double k_t = 2.3;
    const Mixed mixed(k_t, k_0, O, k_t * tilt);
    EXPECT_NEAR(mixed.sums.value[0], p.jacobian * 0.5 * k_t * dot(tilt, tilt), 1e-14);
    for (unsigned int c = 0; c < 3; ++c)
      EXPECT_NEAR(mixed.sums.gradient[12 + c], 0., 1e-14);
  }
  // With k_t = inf normal directors bear any tangential shear ...
  const double infinity = std::numeric_limits<double>::infinity();
  const Mixed normal(infinity, 0.7, p.normal, {0.4 * p.base[0] - 0.1 * p.base[1]});
  EXPECT_NEAR(normal.sums.value[0], 0., 1e-15);
  for (unsigned int c = 0; c < 3; ++c)
    EXPECT_NEAR(normal.sums.gradient[12 + c], 0., 1e-15);
  // ... and q has no normal part.
  EXPECT_NEAR(Mixed(infinity, 0.7, p.normal, 0.3 * p.normal).sums.value[0],
              -p.jacobian * 0.09 * MixedTiltEnergy::normal_weight / (2. * 0.7), 1e-15);
}
} // namespace
