// SPDX-License-Identifier: LGPL-2.1-or-later
// Vectors b_a that the material carries along: (44) of Hu, Zhang & E 2007.
#include "moving_directors.h"

#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/director/transported_director_curvature.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double u = 0.7, v = 1.9; // some place

/** Tangent plane and director there; `normal`: the director is the normal. */
DirectorPoint point_at(const double t, const bool normal)
{
  const Jet x = jet(MovingTorus(), u, v, t);
  return {x.d[0], x.d[1], normal ? TangentPlane<double>(x.d[0], x.d[1]).normal : jet(MovingDirectors(), u, v, t).value};
}

/** Right-hand side of (44), written out. */
FirstDerivatives<double> rate_of_b(const FirstDerivatives<double> &b, const double t)
{
  const Jet x = jet(MovingTorus(), u, v, t), O = jet(MovingDirectors(), u, v, t);
  const TangentPlane<double> p(x.d[0], x.d[1]);
  const double zeta = (dot(p.base[1], x.rate(0)) - dot(p.base[0], x.rate(1))) / p.jacobian;
  FirstDerivatives<double> rate;
  for (unsigned int a = 0; a < 2; ++a)
  {
    rate[a] = (0.5 * zeta) * cross(O.value, b[a]) - dot(O.d[2], b[a]) * O.value;
    for (unsigned int g = 0; g < 2; ++g)
      for (unsigned int c = 0; c < 2; ++c)
        rate[a] += (0.5 * (dot(p.base[a], x.rate(g)) + dot(p.base[g], x.rate(a))) * p.inverse_metric(g, c)) * b[c];
  }
  return rate;
}

FirstDerivatives<double> start_b()
{
  return {jet(SpontaneousVectors{0, 1.}, u, v, 0.).value, jet(SpontaneousVectors{1, 1.}, u, v, 0.).value};
}

TEST(DirectorHistory, StepsAreOfSecondOrder)
{
  constexpr double end           = 0.5;
  FirstDerivatives<double> exact = start_b();
  constexpr int n_exact          = 400;
  for (int i = 0; i < n_exact; ++i)
  {
    const double h = end / n_exact, t = i * h;
    const auto ahead = [&](const FirstDerivatives<double> &k, const double s) {
      return FirstDerivatives<double>{exact[0] + s * k[0], exact[1] + s * k[1]};
    };
    const auto k1 = rate_of_b(exact, t), k2 = rate_of_b(ahead(k1, h / 2.), t + h / 2.),
               k3 = rate_of_b(ahead(k2, h / 2.), t + h / 2.), k4 = rate_of_b(ahead(k3, h), t + h);
    for (unsigned int a = 0; a < 2; ++a)
      exact[a] += (h / 6.) * (k1[a] + 2. * k2[a] + 2. * k3[a] + k4[a]);
  }
  double previous = 0.;
  for (int n = 8; n <= 64; n *= 2)
  {
    std::vector<DirectorHistory> history{{point_at(0., false), start_b()}};
    for (int i = 1; i <= n; ++i)
    {
      transport(history, {point_at(end * i / n, false)});
      for (unsigned int a = 0; a < 2; ++a)
        EXPECT_NEAR(dot(history[0].b[a], history[0].at.O), 0., 1e-14);
    }
    const double error = norm(history[0].b[0] - exact[0]) + norm(history[0].b[1] - exact[1]);
    if (n > 8)
    {
      EXPECT_GT(std::log2(previous / error), 1.9) << n;
      EXPECT_LT(std::log2(previous / error), 2.2) << n;
    }
    previous = error;
  }
}

// Where O = n, b_a = B a_a solves (44) for any motion, and the steps keep it.
TEST(DirectorHistory, NormalDirectorsKeepTheirIsotropicCurvature)
{
  constexpr double B                   = -0.8;
  std::vector<DirectorHistory> history = isotropic_history({point_at(0., true)}, B);
  for (const double t : {0.3, 0.2, 0.7})
  {
    transport(history, {point_at(t, true)});
    const DirectorPoint now = point_at(t, true);
    EXPECT_LT(norm(history[0].b[0] - B * now.x_1), 1e-14);
    EXPECT_LT(norm(history[0].b[1] - B * now.x_2), 1e-14);
  }
}

/** Rotation by the angle about an axis. */
Vector3<double> turned(const Vector3<double> &w, const Vector3<double> &axis, const double angle)
{
  return std::cos(angle) * w + std::sin(angle) * cross(axis, w) + ((1. - std::cos(angle)) * dot(axis, w)) * axis;
}

TEST(DirectorHistory, RigidMotionsCarryNormalDirectorsAndTheirEnergy)
{
  const Vector3<double> axis = unit(Vector3<double>(0.3, -0.5, 0.9));
  const auto turn            = [&](const Vector3<double> &w) { return turned(w, axis, 1.1); };
  const DirectorPoint before = point_at(0., true);
  const Vector3<double> b[2] = {0.4 * before.x_1 - 0.1 * before.x_2, 0.3 * before.x_2 + 0.2 * before.x_1};
  const DirectorHistory history{before, {b[0], b[1]}};
  const auto after = transported(history, TangentPlane<double>(turn(before.x_1), turn(before.x_2)), turn(before.O));
  for (unsigned int a = 0; a < 2; ++a)
    EXPECT_LT(norm(after[a] - turn(b[a])), 1e-14);

  const DensityPotential<TransportedDirectorCurvature> potential(
      "curvature",
      TransportedDirectorCurvature{0.4, 0.15, std::make_shared<const std::vector<DirectorHistory>>(1, history)});
  const Vector3<double> O_1 = 0.3 * before.x_1, O_2(0.2, -0.1, 0.4);
  const double energy =
      evaluate(potential, stacked({Vector3<double>(), before.x_1, before.x_2, before.O, O_1, O_2})).value[0];
  const double energy_after =
      evaluate(potential,
               stacked({Vector3<double>(), turn(before.x_1), turn(before.x_2), turn(before.O), turn(O_1), turn(O_2)}))
          .value[0];
  EXPECT_NEAR(energy_after, energy, 1e-14);
  EXPECT_GT(std::abs(energy), 1e-2);
}

// With tilt the law is not objective: a spin about n at the rate 1 turns b_a about O by 1 instead of O . n.
TEST(DirectorHistory, RigidSpinTurnsTiltedVectorsByTheAngleAboutTheNormal)
{
  const Vector3<double> e_z(0., 0., 1.), O = unit(Vector3<double>(0.5, 0., 1.));
  const double angle = 1e-4;
  const DirectorHistory history{{{1., 0., 0.}, {0., 1., 0.}, O},
                                {Vector3<double>(0., 1., 0.), cross(O, Vector3<double>(0., 1., 0.))}};
  const auto after = transported(
      history, TangentPlane<double>({std::cos(angle), std::sin(angle), 0.}, {-std::sin(angle), std::cos(angle), 0.}),
      turned(O, e_z, angle));
  const Vector3<double> rigid = turned(history.b[0], e_z, angle);
  // The excess angle about O.
  EXPECT_NEAR(dot(after[0] - rigid, turned(history.b[1], e_z, angle)), angle * (1. - dot(O, e_z)), 1e-7 * angle);
}
} // namespace
