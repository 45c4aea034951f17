// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/solids/elastic_body.h>

namespace pellicle
{
/**
 * W = (K/2) (J - 1)^2 per reference volume: pressure p_f = -dW/dJ = K (1 - J), with K = -dp_f/dJ, (122) of Sauer 2014.
 * It has no stiffness against shear: something else must hold the nodes inside.
 */
struct CompressibleLiquid
{
  double bulk_modulus = 1.; ///< K, energy/length^3

  template <typename Number>
  Number energy(const Number & /*I1*/, const Number &J) const
  {
    return 0.5 * bulk_modulus * (J - 1.) * (J - 1.);
  }
};
} // namespace pellicle
