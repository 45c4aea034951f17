// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/elastic_skin.h>

namespace pellicle
{
/**
 * Membrane of red blood cells (Skalak et al. 1973, with the moduli of Barthes-Biesel, Diaz & Dhenin 2002), which
 * resists change of area more than shear, per reference area:
 *
 *     W = (G/4) (I1^2 + 2 I1 - 2 I2 + C I2^2),    I1 = T - 2,    I2 = s^2 - 1,
 *     T_1 = (G/(l1 l2)) (l1^2 (l1^2 - 1) + C l1^2 l2^2 (l1^2 l2^2 - 1)).
 *
 * For small strains the shear modulus is G, the area modulus G (1 + 2 C), the Poisson ratio C/(1 + C). A sphere of
 * reference radius R stretched by l carries P = 2 G ((l^2 - 1) + C l^2 (l^4 - 1))/(l R): no limit point for C >= 0.
 */
struct SkalakSkin
{
  static constexpr const char *name = "skalak skin";
  static std::string description();

  double shear_modulus           = 1.; ///< G, energy/length^2
  double area_dilation_parameter = 1.; ///< C

  template <typename Number>
  Number energy(const Number &T, const Number &s) const
  {
    const Number I1 = T - 2., I2 = s * s - 1.;
    return 0.25 * shear_modulus * (I1 * I1 + 2. * (I1 - I2) + area_dilation_parameter * I2 * I2);
  }

  double modulus() const { return shear_modulus; }
  void bind(ParameterSection &section);
};
} // namespace pellicle
