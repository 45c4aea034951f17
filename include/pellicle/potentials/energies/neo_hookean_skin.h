// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/elastic_skin.h>

namespace pellicle
{
/**
 * Neo-Hookean membrane without thickness, (54) of Sauer 2014 less its constant, per reference area:
 *
 *     W = (mu/2) (T - 2 - 2 ln s),    sigma^ab = (mu/s) (A^ab - a^ab)    (55).
 *
 * -2 ln s is its only term of area: shear modulus and area modulus for small strains are both mu (Poisson ratio 0). A
 * sphere of reference radius R stretched by l carries P = (2 mu/R) (1/l - 1/l^3), at most 4 mu/(3 sqrt(3) R) at
 * l = sqrt(3).
 */
struct NeoHookeanSkin
{
  static constexpr const char *name = "neo-hookean skin";
  static std::string description();

  double shear_modulus = 1.; ///< mu, energy/length^2

  template <typename Number>
  Number energy(const Number &T, const Number &s) const
  {
    using std::log;
    return 0.5 * shear_modulus * (T - 2. - 2. * log(s));
  }

  double modulus() const { return shear_modulus; }
  void bind(ParameterSection &section);
};
} // namespace pellicle
