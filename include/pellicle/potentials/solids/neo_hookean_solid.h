// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/solids/elastic_body.h>

#include <cmath>

namespace pellicle
{
/** U(J) of a compressible solid; dU/dJ(1) = 0 and d2U/dJ2(1) = lambda for both. */
enum class VolumetricLaw
{
  logarithmic, ///< (lambda/2) (ln J)^2
  quadratic    ///< (lambda/4) (J^2 - 1 - 2 ln J)
};

/**
 * Compressible neo-Hookean solid, W = (mu/2) (I1 - 3 - 2 ln J) + U(J):
 *
 *     P = mu (F - F^-T) + lambda ln J F^-T           logarithmic,
 *     P = mu (F - F^-T) + (lambda/2) (J^2 - 1) F^-T  quadratic.
 *
 * For small strains Hooke's law with the Lame constants lambda and mu.
 */
struct NeoHookeanSolid
{
  double mu = 1., lambda = 1.; ///< energy/length^3
  VolumetricLaw volumetric = VolumetricLaw::logarithmic;

  template <typename Number>
  Number energy(const Number &I1, const Number &J) const
  {
    using std::log;
    const Number log_J      = log(J);
    const Number distortion = 0.5 * mu * (I1 - 3. - 2. * log_J);
    if (volumetric == VolumetricLaw::logarithmic)
      return distortion + 0.5 * lambda * log_J * log_J;
    return distortion + 0.25 * lambda * (J * J - 1. - 2. * log_J);
  }

  /** From Young's modulus E > 0 and Poisson's ratio -1 < nu < 1/2 of small strains. */
  static NeoHookeanSolid from_young(const double E, const double nu,
                                    const VolumetricLaw law = VolumetricLaw::logarithmic)
  {
    return {E / (2. * (1. + nu)), E * nu / ((1. + nu) * (1. - 2. * nu)), law};
  }
};
} // namespace pellicle
