// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/vector3.h>

namespace pellicle
{
/** Moduli of the director model, internal units. */
struct DirectorLaw
{
  double tilt_modulus     = 1.; ///< k_t; may be infinite
  double bending_modulus  = 1.; ///< K = k_1 + eps_1
  double gaussian_modulus = 0.; ///< kappa_G = -2 eps_1

  /** k_1, the modulus that spontaneous curvature couples to. */
  double k_1() const { return bending_modulus + 0.5 * gaussian_modulus; }
  /** 2 mu_2 = k_1 - eps_1, the weight of the null Lagrangian. */
  double null_modulus() const { return bending_modulus + gaussian_modulus; }
  /** B of the isotropic spontaneous curvature B_ab = B a_ab whose reduced model (O = n) has the given C0, from C0 =
   * -2 k_1 B/(k_1 + eps_1): on convex surfaces favoured by C0 > 0 it is negative. */
  double isotropic_curvature(const double C0) const { return -0.5 * C0 * bending_modulus / k_1(); }
};

/** The tangent plane and the director at a quadrature point. */
struct DirectorPoint
{
  Vector3<double> x_1, x_2; ///< x,1 x,2
  Vector3<double> O;        ///< of any length: what counts is its direction
};
} // namespace pellicle
