// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/parameters.h>
#include <pellicle/potentials/shell/shell_strains.h>

#include <string>

namespace pellicle
{
/**
 * Saint Venant-Kirchhoff material of a shell: small strains, finite rotations. The energies are per volume of the
 * reference; ShellReference::volume() makes them one per unit of parametric area.
 */
struct ShellMaterial
{
  double young                 = 1.;     ///< E
  double poisson               = 0.3;    ///< nu
  double thickness             = 0.1;    ///< h
  std::string shear_correction = "none"; ///< "none" or "5/6"

  void bind(ParameterSection &section);

  double shear_modulus() const { return young / (2. * (1. + poisson)); }               ///< mu = G
  double lame() const { return 2. * shear_modulus() * poisson / (1. - 2. * poisson); } ///< lambda
  double bending_stiffness() const;                                                    ///< D_b = E h^3/(12 (1 - nu^2))
  /** kappa_s, the factor on the energy of transverse shear: a shear constant over the thickness overestimates that of
   * the parabolic stress of plates by 6/5. */
  double shear_factor() const { return shear_correction == "5/6" ? 5. / 6. : 1.; }

  /** W(E) = (lambda/2)(tr E)^2 + mu E:E less the part of transverse shear, 2 mu |E N|_tan^2. */
  template <typename Number>
  Number plain_energy(const Symmetric6<Number> &E, const Vector3<double> &N) const
  {
    const Number trace   = E[0] + E[1] + E[2];
    const Number squares = E[0] * E[0] + E[1] * E[1] + E[2] * E[2] + 0.5 * (E[3] * E[3] + E[4] * E[4] + E[5] * E[5]);
    return 0.5 * lame() * trace * trace + shear_modulus() * (squares - 2. * shear_square(E, N, 0.5));
  }
  /** kappa_s times that part. */
  template <typename Number>
  Number shear_energy(const Symmetric6<Number> &E, const Vector3<double> &N) const
  {
    return 2. * shear_factor() * shear_modulus() * shear_square(E, N, 0.5);
  }
  /** The energy of both. */
  template <typename Number>
  Number strain_energy(const Symmetric6<Number> &E, const Vector3<double> &N) const
  {
    return plain_energy(E, N) + shear_energy(E, N);
  }

  /** Complementary energies, the largest values of S:E less each part, over the E that it depends on. */
  template <typename Number>
  Number plain_complementary_energy(const Symmetric6<Number> &S, const Vector3<double> &N) const
  {
    const Number trace   = S[0] + S[1] + S[2];
    const Number squares = S[0] * S[0] + S[1] * S[1] + S[2] * S[2] + 2. * (S[3] * S[3] + S[4] * S[4] + S[5] * S[5]);
    return (squares - 2. * shear_square(S, N, 1.) - poisson / (1. + poisson) * trace * trace) / (4. * shear_modulus());
  }
  template <typename Number>
  Number shear_complementary_energy(const Symmetric6<Number> &S, const Vector3<double> &N) const
  {
    return shear_square(S, N, 1.) / (2. * shear_factor() * shear_modulus());
  }

  /**
   * (1/2) beta_a . K^ab . beta_b with Rubin's two-parameter tensors
   *
   *     K^ab = (mu h^2/12) {2 nu/(1 - nu) D^a (x) D^b + D^b (x) D^a + D^ab D_g (x) D^g},
   *
   * of which the factors are those of plane stress: a plate bends with D_b = E h^3/(12 (1 - nu^2)). With the tensor
   * k = beta_a (x) D^a it is (mu h^2/24) {2 nu/(1 - nu) (tr k)^2 + tr(k k) + |P k|^2}, P the projection on the tangent
   * plane.
   */
  template <typename Number>
  Number bending_energy(const std::array<Vector3<Number>, 2> &beta, const ShellReference &D) const
  {
    std::array<std::array<Number, 2>, 2> mixed; // beta_a . D^b
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int b = 0; b < 2; ++b)
        mixed[a][b] = internal::times(D.dual[b], beta[a]);
    const Number trace   = mixed[0][0] + mixed[1][1];
    const Number product = mixed[0][0] * mixed[0][0] + 2. * mixed[0][1] * mixed[1][0] + mixed[1][1] * mixed[1][1];
    Number square        = Number(0.);
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int b = 0; b < 2; ++b)
      {
        const Number tangential =
            dot(beta[a], beta[b]) - internal::times(D.normal, beta[a]) * internal::times(D.normal, beta[b]);
        square += dot(D.dual[a], D.dual[b]) * tangential;
      }
    const double factor = shear_modulus() * thickness * thickness / 24.;
    return factor * (2. * poisson / (1. - poisson) * trace * trace + product + square);
  }

private:
  /** |T N|_tan^2 of the symmetric tensor whose components off the diagonal are `off_diagonal` times those given. */
  template <typename Number>
  static Number shear_square(const Symmetric6<Number> &T, const Vector3<double> &N, const double off_diagonal)
  {
    const Vector3<Number> on_normal(Number(T[0] * N[0] + off_diagonal * (T[5] * N[1] + T[4] * N[2])),
                                    Number(T[1] * N[1] + off_diagonal * (T[5] * N[0] + T[3] * N[2])),
                                    Number(T[2] * N[2] + off_diagonal * (T[4] * N[0] + T[3] * N[1])));
    const Number normal = internal::times(N, on_normal);
    return dot(on_normal, on_normal) - normal * normal;
  }
};
} // namespace pellicle
