// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/elastic_skin.h>

namespace pellicle
{
/**
 * In-plane energy of Tu & Ou-Yang 2004 on Green's strain E_ab = (a_ab - A_ab)/2, so that it is indifferent to
 * rotations, per reference area:
 *
 *     W = (k_d/2) (tr E)^2 + (k_s/2) det E,    k_d = Y/(1 - nu^2),    k_s = -2 Y/(1 + nu),
 *     tr E = A^ab E_ab = (T - 2)/2,            det E = det(A^ac E_cb) = (s^2 - T + 1)/4.
 *
 * That is Hooke's law in plane stress with Y = (three-dimensional Young's modulus) times thickness: shear modulus
 * -k_s/4 = Y/(2 (1 + nu)), area modulus k_d + k_s/4 = Y/(2 (1 - nu)). A sphere of reference radius R stretched by l has
 * W = Y (l^2 - 1)^2/(4 (1 - nu)) and P = Y (l^2 - 1)/((1 - nu) l R). For small strains with any rotation: under even
 * compression the skin goes soft and gives way at l = 1/sqrt(3).
 */
struct TuOuYangSkin
{
  static constexpr const char *name = "tu-ou-yang skin";
  static std::string description();

  double young_modulus = 1.;  ///< Y, energy/length^2
  double poisson_ratio = 0.3; ///< nu

  template <typename Number>
  Number energy(const Number &T, const Number &s) const
  {
    const double k_d   = young_modulus / (1. - poisson_ratio * poisson_ratio);
    const double k_s   = -2. * young_modulus / (1. + poisson_ratio);
    const Number trace = 0.5 * (T - 2.), determinant = 0.25 * (s * s - T + 1.);
    return 0.5 * k_d * trace * trace + 0.5 * k_s * determinant;
  }

  double modulus() const { return young_modulus; }
  void bind(ParameterSection &section);
};
} // namespace pellicle
