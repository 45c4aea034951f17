// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/potential.h>
#include <pellicle/potentials/reference_basis.h>

namespace pellicle
{
/** Volume j = x,1 . (x,2 x x,3) per unit of parametric volume; J = j/J_ref is the volume ratio of the deformation. */
template <typename Number>
Number bulk_volume_density(const FieldAtPoint<Number> &x)
{
  return dot(x.d1(), cross(x.d2(), x.d3()));
}

/** I1 = tr(F^T F) = G^ab x,a . x,b. */
template <typename Number, typename Reference>
Number first_invariant(const FieldAtPoint<Number> &x, const BasicReferenceBasis<Reference> &G)
{
  Number I1 = G.metric(0, 0) * dot(x.slots[1], x.slots[1]);
  for (unsigned int a = 1; a < 3; ++a)
  {
    I1 += G.metric(a, a) * dot(x.slots[1 + a], x.slots[1 + a]);
    for (unsigned int b = 0; b < a; ++b)
      I1 += 2. * G.metric(a, b) * dot(x.slots[1 + a], x.slots[1 + b]);
  }
  return I1;
}

/**
 * Derivatives of j.
 *
 * | code      | symbol                                            |
 * |-----------|---------------------------------------------------|
 * | j_x[a]    | dj/dx,a = x,b x x,c, (a, b, c) cyclic             |
 * | j_xx(a,b) | d2j/(dx,a dx,b) = -[x,c]x for (a, b, c) cyclic, +[x,c]x for (b, a, c), 0 for a = b |
 */
class BulkVolumeDerivatives
{
public:
  double j = 0.;
  std::array<Vector3<double>, 3> j_x;

  explicit BulkVolumeDerivatives(const FieldAtPoint<double> &x)
      : base{{x.d1(), x.d2(), x.d3()}}
  {
    for (unsigned int a = 0; a < 3; ++a)
      j_x[a] = cross(base[(a + 1) % 3], base[(a + 2) % 3]);
    j = dot(base[0], j_x[0]);
  }

  Matrix3 j_xx(const unsigned int a, const unsigned int b) const
  {
    if (a == b)
      return identity3(0.);
    const Matrix3 third = cross_matrix(base[3 - a - b]);
    return b == (a + 1) % 3 ? -1. * third : third;
  }

private:
  std::array<Vector3<double>, 3> base;
};
} // namespace pellicle
