// SPDX-License-Identifier: LGPL-2.1-or-later
// The own energy by itself, with Pellicle::point only: no mesh, no solver. Value and derivatives on a sphere against
// the closed form.
#include "confinement.h"

#include <cmath>
#include <cstdio>

namespace
{
constexpr double pi = 3.14159265358979323846;

/** Inputs x; x,1; x,2 at a point of a sphere with u1 the longitude (0 here) and u2 = z; there J = R. */
std::array<double, 9> sphere_inputs(const double R, const double z)
{
  const double rho = std::sqrt(R * R - z * z);
  return {rho, 0., z, 0., rho, 0., -z / rho, 0., 1.};
}
} // namespace

int main()
{
  const double R = 1.5, k = 2.;

  // What a scene would do with the effect: fill its parameters, take the energies that it contributes.
  custom::ConfinementEffect effect;
  effect.parameters.stiffness = k;
  pellicle::PotentialSet set;
  effect.contribute(pellicle::Scales(), pellicle::SceneTargets(), set);
  const pellicle::Potential &energy = *set.energies.front();

  // The density is quadratic in z and does not depend on the longitude: two Gauss points in z integrate it exactly.
  const double weight          = 2. * pi * R;
  const unsigned int n_inputs  = 9;
  const unsigned int offsets[] = {0};
  double value                 = 0.;
  double homogeneity = 0.; // sum of dE/d(input) * input: 4 E, because E scales with the fourth power of length
  for (const double z : {-R / std::sqrt(3.), R / std::sqrt(3.)})
  {
    const auto inputs = sphere_inputs(R, z);
    pellicle::PointSums sums;
    sums.reset(1, n_inputs, pellicle::Order::hessian);
    energy.add({0, 1, n_inputs, inputs.data()}, offsets, 1., pellicle::Order::hessian, sums);
    value += weight * sums.value[0];
    for (unsigned int i = 0; i < n_inputs; ++i)
      homogeneity += weight * sums.gradient[i] * inputs[i];
  }

  const double exact = 2. * pi / 3. * k * std::pow(R, 4);
  std::printf("%s of a sphere: %.15g, closed form %.15g\n", energy.name().c_str(), value, exact);
  const bool good = std::abs(value / exact - 1.) < 1e-13 && std::abs(homogeneity / (4. * exact) - 1.) < 1e-13;
  return good ? 0 : 1;
}
