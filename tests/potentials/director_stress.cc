// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress and torque of directors as power balances: along any motion of surface, directors and b_a the energy changes
// by the power of the stress (30), (46) of Hu, Zhang & E 2007 with the signs corrected, and of the torque (45).
#include "moving_directors.h"

#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/director/director_gradient.h>
#include <pellicle/potentials/director/tilt_energy.h>
#include <pellicle/potentials/director/transported_director_curvature.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double k_t = 1.7, mu_1 = 0.4, mu_2 = 0.15;
constexpr unsigned int n_points = 40;

/** Everything at one place and time; b may be given, as it is history. */
struct State
{
  Jet x, O;
  TangentPlane<double> p;
  FirstDerivatives<double> b, P; ///< P_a = O,a + b_a

  State(const double u, const double v, const double t, const FirstDerivatives<double> &b)
      : x(jet(MovingTorus(), u, v, t))
      , O(jet(MovingDirectors(), u, v, t))
      , p(x.d[0], x.d[1])
      , b(b)
      , P{O.d[0] + b[0], O.d[1] + b[1]}
  {
  }

  /** e^ab */
  double permutation(const unsigned int a, const unsigned int b_) const
  {
    return (double(b_) - double(a)) / p.jacobian;
  }

  /** The energy (43) per area, its null term included. */
  double energy() const
  {
    const double tilt = dot(O.value, O.value) - std::pow(dot(O.value, p.normal), 2);
    return 0.5 * k_t * tilt + mu_1 * gradient_product(p, P, P) +
           2. * mu_2 * dot(cross(P[0], P[1]), O.value) / p.jacobian;
  }

  /** zeta = e^ab a_b . v,a and the mixed rate of strain S_a^p. */
  double vorticity() const { return (dot(p.base[1], x.rate(0)) - dot(p.base[0], x.rate(1))) / p.jacobian; }
  double strain_rate(const unsigned int a, const unsigned int c) const
  {
    double sum = 0.;
    for (unsigned int g = 0; g < 2; ++g)
      sum += 0.5 * (dot(p.base[a], x.rate(g)) + dot(p.base[g], x.rate(a))) * p.inverse_metric(g, c);
    return sum;
  }

  /** d_t b_a by (44). */
  FirstDerivatives<double> rate_of_b() const
  {
    FirstDerivatives<double> rate;
    for (unsigned int a = 0; a < 2; ++a)
      rate[a] = strain_rate(a, 0) * b[0] + strain_rate(a, 1) * b[1] + (0.5 * vorticity()) * cross(O.value, b[a]) -
                dot(O.d[2], b[a]) * O.value;
    return rate;
  }

  /** Power per area of T1^ab (first index: the cut) and of the transverse k_t O^n O^a. `sign` is that of the bracket of
   * mu_1: -1, and 1 as printed. */
  double power_of_stress(const double sign = -1.) const
  {
    const auto &up = p.inverse_metric;
    // P_g . O,d and (P_g x O,d) . O
    double inner[2][2], triple[2][2];
    for (unsigned int g = 0; g < 2; ++g)
      for (unsigned int d = 0; d < 2; ++d)
      {
        inner[g][d]  = dot(P[g], O.d[d]);
        triple[g][d] = dot(cross(P[g], O.d[d]), O.value);
      }
    double skew = 0.;
    for (unsigned int g = 0; g < 2; ++g)
      for (unsigned int d = 0; d < 2; ++d)
        skew += mu_1 * up(g, d) * triple[g][d] - mu_2 * permutation(g, d) * inner[g][d];
    const double density = energy();
    double power         = 0.;
    for (unsigned int a = 0; a < 2; ++a)
    {
      for (unsigned int b_ = 0; b_ < 2; ++b_)
      {
        double T1 = density * up(a, b_) + permutation(a, b_) * skew;
        for (unsigned int g = 0; g < 2; ++g)
          for (unsigned int d = 0; d < 2; ++d)
            T1 += sign * mu_1 * (up(a, g) * up(b_, d) + up(a, d) * up(b_, g)) * inner[g][d] +
                  mu_2 * (permutation(a, g) * up(b_, d) + permutation(b_, g) * up(a, d)) * triple[g][d];
        power += T1 * dot(p.base[b_], x.rate(a));
      }
      power += k_t * dot(O.value, p.normal) * dot(O.value, p.dual[a]) * dot(p.normal, x.rate(a));
    }
    return power;
  }
};

FirstDerivatives<double> vectors_b(const double u, const double v, const double size)
{
  return {jet(SpontaneousVectors{0, size}, u, v, 0.).value, jet(SpontaneousVectors{1, size}, u, v, 0.).value};
}

/** b_a at time h, from b_a at time 0: a step of Runge and Kutta of (44). */
FirstDerivatives<double> carried(const double u, const double v, const FirstDerivatives<double> &b, const double h)
{
  const auto ahead = [&](const FirstDerivatives<double> &k, const double s) {
    return FirstDerivatives<double>{b[0] + s * k[0], b[1] + s * k[1]};
  };
  const auto k1 = State(u, v, 0., b).rate_of_b(), k2 = State(u, v, h / 2., ahead(k1, h / 2.)).rate_of_b(),
             k3 = State(u, v, h / 2., ahead(k2, h / 2.)).rate_of_b(), k4 = State(u, v, h, ahead(k3, h)).rate_of_b();
  FirstDerivatives<double> result = b;
  for (unsigned int a = 0; a < 2; ++a)
    result[a] += (h / 6.) * (k1[a] + 2. * k2[a] + 2. * k3[a] + k4[a]);
  return result;
}

/** dE/dt by differences of fourth order, of the power of stress and of that of the torque (45). */
struct Balance
{
  double rate = 0., stress = 0., printed_stress = 0., torque = 0.;

  explicit Balance(const double size_of_b)
  {
    constexpr double h = 4e-3;
    over_torus(n_points,
               [&](const double u, const double v, const double weight)
               {
                 const FirstDerivatives<double> b = vectors_b(u, v, size_of_b);
                 const auto energy                = [&](const double t)
                 {
                   const State s(u, v, t, carried(u, v, b, t));
                   return s.energy() * s.p.jacobian;
                 };
                 rate += weight * (8. * (energy(h) - energy(-h)) - energy(2. * h) + energy(-2. * h)) / (12. * h);
                 const State s(u, v, 0., b);
                 stress += weight * s.p.jacobian * s.power_of_stress();
                 printed_stress += weight * s.p.jacobian * s.power_of_stress(1.);
                 torque += weight * s.p.jacobian * dot(couple(s, u, v, size_of_b), cross(s.O.value, s.O.d[2]));
               });
  }

  /** (45): couple on O per area, 2 mu_1 a^ab O x P_a;b + 2 mu_2 e^ab O x (O x b_a;b) - k_t O^a O x a_a. */
  static Vector3<double> couple(const State &s, const double u, const double v, const double size_of_b)
  {
    const SurfacePoint<double> p(s.x.d[0], s.x.d[1], s.x.dd[0][0], s.x.dd[0][1], s.x.dd[1][1]);
    const Jet b[2] = {jet(SpontaneousVectors{0, size_of_b}, u, v, 0.), jet(SpontaneousVectors{1, size_of_b}, u, v, 0.)};
    Vector3<double> divergence, curl = (1. / p.jacobian) * (b[0].d[1] - b[1].d[0]);
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int c = 0; c < 2; ++c)
        divergence += p.inverse_metric(a, c) *
                      (s.O.dd[a][c] + b[a].d[c] - p.christoffel[0](a, c) * s.P[0] - p.christoffel[1](a, c) * s.P[1]);
    const Vector3<double> tilt = tangential_part(p, s.O.value);
    return cross(s.O.value, (2. * mu_1) * divergence + (2. * mu_2) * cross(s.O.value, curl) - k_t * tilt);
  }
};

TEST(DirectorStress, PowerBalanceWithoutSpontaneousCurvature)
{
  const Balance balance(0.);
  EXPECT_NEAR(balance.stress - balance.torque, balance.rate, 1e-8 * std::abs(balance.rate));
  // (30), (36) and (37) print a plus.
  EXPECT_GT(std::abs(balance.printed_stress - balance.torque - balance.rate), 0.1 * std::abs(balance.rate));
}

TEST(DirectorStress, PowerBalanceWithSpontaneousCurvature)
{
  const Balance balance(0.5);
  EXPECT_NEAR(balance.stress - balance.torque, balance.rate, 1e-8 * std::abs(balance.rate));
  EXPECT_GT(std::abs(balance.printed_stress - balance.torque - balance.rate), 0.1 * std::abs(balance.rate));
}

// The gradient of what is assembled does that power, the null term aside, of which the integral does not change.
TEST(DirectorStress, GradientsOfTheDensitiesDoThatPower)
{
  const DensityPotential<TiltEnergy> tilt("tilt", TiltEnergy{k_t});
  const DensityPotential<DirectorGradientEnergy> gradient("gradient", DirectorGradientEnergy{2. * mu_1});
  const Balance balance(0.5);
  double power = 0.;
  over_torus(n_points,
             [&](const double u, const double v, const double weight)
             {
               const State s(u, v, 0., vectors_b(u, v, 0.5));
               const auto history = std::make_shared<const std::vector<DirectorHistory>>(
                   1, DirectorHistory{{s.x.d[0], s.x.d[1], s.O.value}, s.b});
               const DensityPotential<TransportedDirectorCurvature> curvature(
                   "curvature", TransportedDirectorCurvature{mu_1, mu_2, history});
               const auto inputs = stacked({s.x.value, s.x.d[0], s.x.d[1], s.O.value, s.O.d[0], s.O.d[1]}),
                          rates  = stacked({s.x.d[2], s.x.rate(0), s.x.rate(1), s.O.d[2], s.O.rate(0), s.O.rate(1)});
               for (const Potential *potential : std::initializer_list<const Potential *>{&tilt, &gradient, &curvature})
                 power += weight * product(evaluate(*potential, inputs).gradient, rates);
             });
  EXPECT_NEAR(power, balance.stress - balance.torque, 1e-10 * std::abs(power));
}

/** Derivative of the integral of a density of the directors alone in the direction of O_t + w O: the lengths change. */
template <typename Density>
double variation(const Density &density)
{
  const DensityPotential<Density> potential("null", density);
  double sum = 0.;
  over_torus(n_points,
             [&](const double u, const double v, const double weight)
             {
               const Jet O    = jet(MovingDirectors(), u, v, 0.);
               const double w = std::cos(u), w_u = -std::sin(u);
               const std::array<Vector3<double>, 3> inputs{O.value, O.d[0], O.d[1]},
                   rates{O.d[2] + w * O.value, O.rate(0) + w * O.d[0] + w_u * O.value, O.rate(1) + w * O.d[1]};
               const unsigned int offset = 0;
               PointSums sums;
               sums.reset(1, 9, Order::gradient);
               potential.add({0, 1, 9, inputs[0].components.data()}, &offset, 1., Order::gradient, sums);
               for (unsigned int i = 0; i < 9; ++i)
                 sum += weight * sums.gradient[i] * rates[i / 3][i % 3];
             });
  return sum;
}

/** O . (O,1 x O,2) of the plain interpolation. */
struct PlainTriple
{
  static constexpr std::array<FieldUse, 1> fields   = NullLagrangian::fields;
  static constexpr bool reparametrisation_invariant = true;

  template <typename Number>
  Number density(const PointInputs<Number, 1> &inputs, const PointData & /*data*/) const
  {
    return dot(inputs[0].value(), cross(inputs[0].d1(), inputs[0].d2()));
  }
};

TEST(DirectorStress, NullLagrangianHasNoVariationButThePlainInterpolationHas)
{
  EXPECT_NEAR(variation(NullLagrangian{1.}), 0., 1e-10);
  EXPECT_GT(std::abs(variation(PlainTriple{})), 1e-2);
}
} // namespace
