// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/elastic_skin.h>

namespace pellicle
{
/**
 * Skin of incompressible neo-Hookean rubber in plane stress, (57)-(60) of Sauer 2014 with the thickness stretch
 * l3 = 1/s, per reference area:
 *
 *     W = (mu/2) (T + 1/s^2 - 3),    sigma^ab = (mu/s) (A^ab - a^ab/s^2)    (60).
 *
 * mu is the shear modulus of the rubber times the reference thickness. For small strains the shear modulus is mu, the
 * area modulus 3 mu (Young's modulus 3 mu, Poisson ratio 1/2). A sphere of reference radius R stretched by l carries
 * P = (2 mu/R) (1/l - 1/l^7), at most 1.239462902 mu/R at l = 7^(1/6).
 */
struct IncompressibleRubberSkin
{
  static constexpr const char *name = "incompressible rubber skin";
  static std::string description();

  double shear_modulus = 1.; ///< mu, energy/length^2

  template <typename Number>
  Number energy(const Number &T, const Number &s) const
  {
    return 0.5 * shear_modulus * (T + 1. / (s * s) - 3.);
  }

  double modulus() const { return shear_modulus; }
  void bind(ParameterSection &section);
};
} // namespace pellicle
