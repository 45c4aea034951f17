// SPDX-License-Identifier: LGPL-2.1-or-later
// Cosserat shells solved: plates, balloons and rings with exact values, benchmarks of the literature, and no locking.
#include "shell_runs.h"

#include "../expect_user_error.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::test;
using Vector = Vector3<double>;

// Navier's plate under p sin(pi x/a) sin(pi y/b): w = p/(D k^4) (1 + D k^2/(kappa_s G h)), k^2 = (pi/a)^2 + (pi/b)^2.
TEST(Plate, DeflectionUnderSinusoidalLoadIsNaviers)
{
  for (const char *correction : {"none", "5/6"})
    for (const double h : {0.3, 0.03})
    {
      ShellScene scene         = shell_scene("plate", "dead load", 3, 2);
      scene.shell.length       = 2.;
      scene.shell.width        = 3.;
      scene.shell.load_shape   = "sin(pi*x/2)*sin(pi*y/3)";
      ShellMaterial &shell     = effect<CosseratShellEffect>(scene).parameters;
      shell.young              = 1e4;
      shell.thickness          = h;
      shell.shear_correction   = correction;
      DeadLoadParameters &load = effect<DeadLoadEffect>(scene).parameters;
      const double k2          = pi * pi * (1. / 4. + 1. / 9.);
      const double D           = shell.bending_stiffness();
      const double per_load = 1. / (D * k2 * k2) * (1. + D * k2 / (shell.shear_factor() * shell.shear_modulus() * h));
      load.force            = {0., 0., -1.};
      load.scale            = 1e-5 * h / per_load; // so small a deflection that the plate is linear
      const Solved plate(scene);
      ASSERT_TRUE(plate.result.converged);
      EXPECT_LT(relative_error(plate.quantity("displacement_at_load_point_a"), load.scale * per_load), 1e-4)
          << h << ", " << correction;
    }
}

/** The uniform state of a sphere of radius 1 stretched by l, with the director's length d: energy, exactly. */
template <typename Number>
Number energy_of_balloon(const ShellMaterial &m, const Number &l, const Number &d)
{
  const Vector e1(1., 0., 0.), e2(0., 1., 0.), e3(0., 0., 1.);
  const ShellReference D({{e1, e2, e3}}, {{e1, e2}}, e3);
  FieldAtPoint<Number> x, director;
  for (auto *field : {&x, &director})
    for (auto &slot : field->slots)
      slot = {Number(0.), Number(0.), Number(0.)};
  x.slots[1][0] = x.slots[2][1] = l;
  director.slots[0][2] = director.slots[1][0] = director.slots[2][1] = d;
  const ShellStrains<Number> strains(x, director, D, D.first_moments(m.thickness));
  const Number strain = m.strain_energy(strains.strain, D.normal), bending = m.bending_energy(strains.couple, D);
  return 4. * pi * D.volume(m.thickness) * (strain + bending);
}

// P = dE/dV at the best d. The thin limit is P = E h (l^2 - 1)/((1 - nu) l R); the model departs from it by (h/R)^2.
TEST(Balloon, PressureIsThatOfTheUniformState)
{
  ShellMaterial m;
  m.young        = 1.;
  m.poisson      = 0.3;
  const double l = 1.1;
  for (const double h : {0.1, 0.01})
  {
    m.thickness = h;
    double d    = 1.;
    double P    = 0.;
    for (int iteration = 0; iteration < 20; ++iteration)
    {
      using Number   = SecondOrder<2>;
      const Number E = energy_of_balloon<Number>(m, seed<Number>(0, l), seed<Number>(1, d));
      d -= E.dx(1).val() / E.dx(1).dx(1);
      P = E.dx(0).val() / (4. * pi * l * l);
    }
    const double thin = m.young * h * (l * l - 1.) / ((1. - m.poisson) * l);
    EXPECT_NEAR(P / thin, 1., h * h);
    ShellScene scene                                  = shell_scene("sphere", "pressure", 3, 1);
    scene.shell.radius                                = 1.;
    effect<CosseratShellEffect>(scene).parameters     = m;
    effect<PressureEffect>(scene).parameters.pressure = P;
    const Solved balloon(scene);
    ASSERT_TRUE(balloon.result.converged) << balloon.result.failure;
    EXPECT_NEAR(balloon.quantity("displacement_at_load_point_a"), l - 1., 1e-5) << h;
  }
}

/** A ring under the load p (X/R) e_x per area: displacements W cos 2 phi and V sin 2 phi, changes A cos 2 phi and
 * B sin 2 phi of the director, found exactly from the linear model; W + that of the mode 0, by p. */
double ring_displacement(const ShellMaterial &m, const double R)
{
  using Number    = SecondOrder<4>;
  double at_phi_0 = 0.;
  for (const int mode : {0, 2})
  {
    Eigen::Matrix4d stiffness = Eigen::Matrix4d::Zero();
    Eigen::Vector4d load      = Eigen::Vector4d::Zero();
    constexpr int n           = 16;
    for (int i = 0; i < n; ++i)
    {
      const double phi = 2. * pi * (i + 0.3) / n, c = std::cos(mode * phi), s = std::sin(mode * phi);
      const Vector er(std::cos(phi), std::sin(phi), 0.), et(-std::sin(phi), std::cos(phi), 0.), ez(0., 0., 1.);
      const ShellReference D({{R * et, ez, er}}, {{et, Vector()}}, R * er);
      std::array<Number, 4> a;
      for (unsigned int k = 0; k < 4; ++k)
        a[k] = seed<Number>(k, 0.);
      // r c e_r + t s e_phi and its derivative with respect to phi
      const auto value = [&](const Number &r, const Number &t)
      {
        Vector3<Number> v;
        for (unsigned int k = 0; k < 3; ++k)
          v[k] = r * (c * er[k]) + t * (s * et[k]);
        return v;
      };
      const auto derivative = [&](const Number &r, const Number &t)
      {
        Vector3<Number> v;
        for (unsigned int k = 0; k < 3; ++k)
          v[k] = r * (c * et[k] - mode * s * er[k]) + t * (mode * c * et[k] - s * er[k]);
        return v;
      };
      FieldAtPoint<Number> x, d;
      const auto plus = [](const Vector &v, const Vector3<Number> &w)
      { return Vector3<Number>(Number(v[0] + w[0]), Number(v[1] + w[1]), Number(v[2] + w[2])); };
      const Vector3<Number> zero(Number(0.), Number(0.), Number(0.));
      x.slots[1] = plus(R * et, derivative(a[0], a[1]));
      x.slots[2] = plus(ez, zero);
      d.slots[0] = plus(er, value(a[2], a[3]));
      d.slots[1] = plus(et, derivative(a[2], a[3]));
      d.slots[2] = zero;
      const ShellStrains<Number> strains(x, d, D, D.first_moments(m.thickness));
      const Number strain = m.strain_energy(strains.strain, D.normal), bending = m.bending_energy(strains.couple, D);
      const Number energy = D.volume(m.thickness) * (strain + bending);
      const Vector force(D.area * std::cos(phi), 0., 0.);
      for (int k = 0; k < 4; ++k)
        for (int l = 0; l < 4; ++l)
          stiffness(k, l) += energy.dx(k).dx(l) / n;
      load += Eigen::Vector4d(c * dot(force, er), s * dot(force, et), 0., 0.) / n;
    }
    if (mode == 0) // neither turns
      stiffness(1, 1) = stiffness(3, 3) = 1.;
    at_phi_0 += stiffness.fullPivLu().solve(load)[0];
  }
  return at_phi_0;
}

// From thick to thin the error is the same, although membrane and shear strains cost (R/h)^2 as much as bending.
// (Displacements alone lock: doc/numerics.md, "Shells".)
TEST(Ring, DoesNotLock)
{
  const double R = 10.;
  for (const auto &[degree, refinements, bound] :
       {std::tuple<int, int, double>{3, 0, 0.04}, {3, 1, 5e-3}, {2, 2, 0.03}})
    for (const double ratio : {1e-1, 1e-2, 1e-3, 1e-4})
    {
      ShellScene scene       = shell_scene("cylinder", "dead load", degree, refinements);
      scene.shell.radius     = R;
      scene.shell.length     = 10.;
      scene.shell.load_shape = "x/10";
      ShellMaterial &shell   = effect<CosseratShellEffect>(scene).parameters;
      shell.poisson          = 0.;
      shell.thickness        = ratio * R;
      const double exact     = ring_displacement(shell, R);
      // Inextensional bending without shear: w = p R^4/(12 E h^3/12).
      const double thin = std::pow(R, 4) / std::pow(shell.thickness, 3);
      EXPECT_NEAR(exact / thin, 1., 2. * ratio * ratio + 1e-6);
      DeadLoadParameters &load = effect<DeadLoadEffect>(scene).parameters;
      load.force               = {1., 0., 0.};
      load.scale               = 1e-3 * R / exact;
      const Solved ring(scene);
      ASSERT_TRUE(ring.result.converged) << ring.result.failure;
      EXPECT_LT(relative_error(ring.quantity("displacement_at_load_point_a"), 1e-3 * R), bound)
          << ratio << ", degree " << degree << ", refinements " << refinements;
      EXPECT_LE(ring.record.iterations.size(), 8u);
    }
}

// Scordelis & Lo: R = 25, L = 50, 40 degrees, t = .25, E = 4.32e8, nu = 0, weight 90 per area; vertical displacement of
// the middle of the free edges, linear theory.
TEST(ScordelisLoRoof, DeflectionIsThatOfTheLiterature)
{
  ShellScene scene         = shell_scene("roof", "dead load", 3, 1);
  scene.shell.radius       = 25.;
  scene.shell.length       = 50.;
  scene.shell.angle        = 40.;
  ShellMaterial &shell     = effect<CosseratShellEffect>(scene).parameters;
  shell.young              = 4.32e8;
  shell.poisson            = 0.;
  shell.thickness          = 0.25;
  DeadLoadParameters &load = effect<DeadLoadEffect>(scene).parameters;
  load.force               = {0., 0., -90.};
  load.scale               = 1e-4;
  const Solved roof(scene);
  ASSERT_TRUE(roof.result.converged);
  const double deflection = roof.quantity("load_point_displacement") / load.scale;
  EXPECT_GT(deflection, 0.3006);
  EXPECT_LT(deflection, 0.3024);
  // The same model by an independent code of high degree. A wrong one may well be within 1 %.
  EXPECT_NEAR(deflection, 0.3013937, 2e-3 * 0.3013937);
}

TEST(PinchedHemisphere, DisplacementIsThatOfTheLiterature)
{
  const double factor = 1e-3; // linear
  const Solved linear(pinched_hemisphere(2. * factor, 3, 2));
  ASSERT_TRUE(linear.result.converged);
  const double a = linear.quantity("displacement_at_load_point_a"), b = linear.quantity("displacement_at_load_point_b");
  EXPECT_NEAR(a / factor, 0.0940, 0.01 * 0.0940);
  EXPECT_NEAR(a / factor, 0.09372, 3e-3 * 0.09372); // converged, by an independent code of high degree
  EXPECT_NEAR(b / a, 1., 1e-4);
  // Clapeyron, for the energy of the whole: forces F at two points of each kind.
  EXPECT_NEAR(linear.quantity("total_energy") / (-0.5 * 2. * factor * 2. * (a + b)), 1., 1e-4);

  const Solved run(pinched_hemisphere(2., 3, 2));
  ASSERT_TRUE(run.result.converged);
  EXPECT_NEAR(run.quantity("load_point_displacement"), 0.0940, 0.01 * 0.0940);
  EXPECT_LE(run.record.iterations.size(), 8u);
}

// The load falls with h^3, so that the deflection has a limit. The reference is the finer mesh.
TEST(PinchedHemisphere, DoesNotLock)
{
  for (const double ratio : {1e-2, 1e-3, 1e-4})
  {
    double deflection[2];
    for (const int refinements : {1, 2})
    {
      const double h = 10. * ratio, force = 2e-3 * std::pow(h / 0.04, 3);
      ShellScene scene                                        = pinched_hemisphere(force, 3, refinements);
      effect<CosseratShellEffect>(scene).parameters.thickness = h;
      const Solved run(scene);
      ASSERT_TRUE(run.result.converged) << run.result.failure;
      deflection[refinements - 1] = run.quantity("displacement_at_load_point_a");
    }
    EXPECT_NEAR(deflection[0] / deflection[1], 1., 0.03) << ratio;
    EXPECT_GT(deflection[1] / 1e-3, 0.09) << ratio;
  }
}

TEST(PinchedHemisphere, NewtonsMethodIsQuadraticAtLargeRotations)
{
  ShellScene scene = pinched_hemisphere(20., 3, 1);
  Solved run(scene);
  ASSERT_TRUE(run.result.converged);
  effect<PointLoadsEffect>(scene).parameters.force = 25.;
  run.model.update(scene);
  run.record.iterations.clear();
  run.result = run.model.solve(2, run.record);
  ASSERT_TRUE(run.result.converged);
  expect_quadratic_tail(run.record.iterations, 1e-3, 1e3, 1e-9);
}

TEST(ShellScenes, RefuseWhatMakesNoSense)
{
  ShellScene pressed = shell_scene("roof", "pressure", 3, 1);
  expect_user_error([&] { pressed.check(); }, {"pressure", "roof", "sphere"});
  ShellScene axial    = pinched_hemisphere(2., 3, 1);
  axial.mesh.symmetry = "axial";
  expect_user_error([&] { axial.check(); }, {"Mesh/Symmetry", "none"});
  ShellScene idle       = pinched_hemisphere(2., 3, 1);
  idle.shell.load_shape = "x";
  expect_user_error([&] { idle.check(); }, {"Load shape", "dead load"});
  ShellScene unreadable       = shell_scene("plate", "dead load", 3, 2);
  unreadable.shell.load_shape = "sin(";
  expect_user_error([&] { unreadable.check(); }, {"sin("});
  EXPECT_NO_THROW(pinched_hemisphere(2., 3, 1).check());
}
} // namespace
