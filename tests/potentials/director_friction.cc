// SPDX-License-Identifier: LGPL-2.1-or-later
// Dissipation potentials of directors over a step, at points of a sphere.
#include <pellicle/base/constants.h>
#include <pellicle/potentials/dissipations/director_friction.h>

#include "../surfaces.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{
using namespace pellicle;
using Vector = Vector3<double>;

/** A sphere at points of a product rule over its angles, and directors on it. */
struct SphereOfDirectors
{
  static constexpr unsigned int n_polar = 24, n_azimuth = 8, n_inputs = 12; // x x,1 x,2 O
  static constexpr unsigned int n_points = n_polar * n_azimuth;
  const double R                         = 1.3;

  /** Inputs of all points; directors at a constant angle to the normal, about the azimuthal direction. */
  std::vector<double> inputs(const double tilt) const
  {
    std::vector<double> all;
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const double u = polar(q / n_azimuth), v = 2. * pi * (q % n_azimuth) / n_azimuth;
      const auto at  = test_surfaces::sample(test_surfaces::Sphere{R}, u, v);
      const Vector n = (1. / R) * at.x, e_u = (1. / R) * at.first[0];
      for (const Vector &slot : {at.x, at.first[0], at.first[1], std::cos(tilt) * n + std::sin(tilt) * e_u})
        for (unsigned int c = 0; c < 3; ++c)
          all.push_back(slot[c]);
    }
    return all;
  }

  /** Integral of a potential, with the derivatives by the inputs if asked for. */
  double integral(const Potential &potential, const std::vector<double> &at,
                  std::vector<double> *gradient = nullptr) const
  {
    const std::vector<unsigned int> offsets{0, 9};
    PointSums sums;
    sums.reset(n_points, n_inputs, Order::gradient);
    potential.add({0, n_points, n_inputs, at.data()}, offsets.data(), 1., Order::gradient, sums);
    double sum = 0.;
    for (unsigned int q = 0; q < n_points; ++q)
      sum += sums.value[q] * pi / n_polar * 2. * pi / n_azimuth;
    if (gradient != nullptr)
      *gradient = sums.gradient;
    return sum;
  }

  static double polar(const unsigned int i) { return pi * (i + 0.5) / n_polar; }
};

/** All vectors changed at rates w x v, positions also at a rate t. */
std::vector<double> after_rigid_motion(const std::vector<double> &inputs, const Vector &w, const Vector &t,
                                       const double dt)
{
  std::vector<double> moved = inputs;
  for (std::size_t i = 0; i < inputs.size(); i += 3)
  {
    const Vector rate = cross(w, Vector(inputs[i], inputs[i + 1], inputs[i + 2])) + (i % 12 == 0 ? t : Vector());
    for (unsigned int c = 0; c < 3; ++c)
      moved[i + c] += dt * rate[c];
  }
  return moved;
}

// The midpoint rule in the polar angle is of second order: twice as many points, a quarter of the error. With sin^3 the
// integrand it is exact but for 1e-5.
TEST(DirectorFriction, OfASpinningSphereInTheLab)
{
  const SphereOfDirectors sphere;
  const double eta = 0.7, w = 1.9, dt = 0.4;
  const Dissipation lab           = make_dissipation("lab", DirectorFrictionInLab{eta});
  const std::vector<double> start = sphere.inputs(0.);
  const auto spun                 = after_rigid_motion(start, {0., 0., w}, {0.3, -0.1, 0.6}, dt);
  EXPECT_EQ(sphere.integral(*lab.over_step, spun), 0.) << "without a step there is no friction";
  lab.start->length = dt;
  lab.start->inputs = start;
  const double D    = sphere.integral(*lab.over_step, spun) / dt;
  EXPECT_NEAR(2. * D / (8. * pi / 3. * eta * w * w * sphere.R * sphere.R), 1., 2e-5);
}

TEST(DirectorFriction, ObjectiveFrictionIgnoresRigidMotions)
{
  const SphereOfDirectors sphere;
  for (const double tilt : {0., 0.8})
    for (const Vector &w : {Vector(0., 0., 1.9), Vector(0.4, -1.1, 0.3)})
    {
      const Dissipation objective = make_dissipation("objective", ObjectiveDirectorFriction{0.7});
      objective.start->length     = 0.4;
      objective.start->inputs     = sphere.inputs(tilt);
      std::vector<double> gradient;
      const auto moved = after_rigid_motion(objective.start->inputs, w, {0.3, -0.1, 0.6}, 0.4);
      EXPECT_NEAR(sphere.integral(*objective.over_step, moved, &gradient), 0., 1e-28) << tilt;
      for (const double g : gradient)
        ASSERT_NEAR(g, 0., 1e-14);
    }
}

// Where the surface stays both forms are the same; turned alone by rates of a spin, directors feel it in both.
TEST(DirectorFriction, FormsAgreeOnASurfaceAtRest)
{
  const SphereOfDirectors sphere;
  const Dissipation lab           = make_dissipation("lab", DirectorFrictionInLab{0.7}),
                    objective     = make_dissipation("objective", ObjectiveDirectorFriction{0.7});
  const std::vector<double> start = sphere.inputs(0.3);
  for (const Dissipation &each : {lab, objective})
  {
    each.start->length = 0.2;
    each.start->inputs = start;
  }
  std::vector<double> turned = after_rigid_motion(start, {0.4, -1.1, 0.3}, {}, 0.2);
  for (std::size_t i = 0; i < start.size(); ++i)
    if (i % 12 < 9)
      turned[i] = start[i];
  const double in_lab = sphere.integral(*lab.over_step, turned);
  EXPECT_GT(in_lab, 0.1);
  EXPECT_NEAR(sphere.integral(*objective.over_step, turned), in_lab, 1e-14);
}

// A membrane that spins under directors at rest: as if these turned the other way. So it is loaded as well.
TEST(DirectorFriction, ObjectiveFrictionLoadsTheMembrane)
{
  const SphereOfDirectors sphere;
  const Dissipation objective     = make_dissipation("objective", ObjectiveDirectorFriction{0.7});
  const std::vector<double> start = sphere.inputs(0.3);
  objective.start->length         = 0.2;
  objective.start->inputs         = start;
  const Vector w(0.4, -1.1, 0.3);
  std::vector<double> spun = after_rigid_motion(start, w, {}, 0.2), turned = after_rigid_motion(start, -w, {}, 0.2);
  for (std::size_t i = 0; i < start.size(); ++i)
    (i % 12 < 9 ? turned : spun)[i] = start[i];
  std::vector<double> gradient;
  const double of_membrane = sphere.integral(*objective.over_step, spun, &gradient);
  EXPECT_NEAR(of_membrane, sphere.integral(*objective.over_step, turned), 1e-14);
  double load = 0.;
  for (std::size_t i = 0; i < gradient.size(); ++i)
    if (i % 12 >= 3 && i % 12 < 9)
      load = std::max(load, std::abs(gradient[i]));
  EXPECT_GT(load, 0.01);
}
} // namespace
