// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/vector3.h>

#include <array>

namespace pellicle
{
/**
 * The undeformed shell at a point: base vectors D_a = X,a and director D_3, which is the unit normal up to the error of
 * interpolation; the dual basis D^i . D_j = delta^i_j belongs to the three as they are, so that the reference has no
 * strain at all.
 */
struct ShellReference
{
  std::array<Vector3<double>, 3> base;       ///< D_1 D_2 D_3
  std::array<Vector3<double>, 3> dual;       ///< D^1 D^2 D^3
  std::array<Vector3<double>, 2> director_d; ///< D_3,1 D_3,2
  Vector3<double> normal;                    ///< unit normal, along D_1 x D_2
  Vector3<double> place;                     ///< X
  double area            = 1.;               ///< sqrt(D) = [D_1, D_2, D_3], per unit of parametric area
  double gauss_curvature = 0.;               ///< [D_3,1, D_3,2, D_3]/sqrt(D)

  ShellReference(const std::array<Vector3<double>, 3> &bases,
                 const std::array<Vector3<double>, 2> &director_derivatives, const Vector3<double> &X);

  /**
   * m/rho_0 = sqrt(D) h (1 + h^2 K/12), the volume of a shell of thickness h per unit of parametric area (paper 003,
   * "Mass per unit area").
   */
  double volume(double thickness) const;

  /**
   * H^a = (1/m) integral of rho_0 xi sqrt(G) G^a over the thickness (paper 003): with sqrt(G) G^1 = (D_2 + xi D_3,2) x
   * D_3, and so on cyclically, the integral is (h^3/12) D_3,2 x D_3. Zero where the reference is flat, (h^2/12 R) D^a
   * on a sphere but for terms of higher order in h/R.
   */
  std::array<Vector3<double>, 2> first_moments(double thickness) const;
};
} // namespace pellicle
