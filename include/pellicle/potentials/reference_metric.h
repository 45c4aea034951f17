// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace pellicle
{
/** Metric A_ab of a reference parametrisation at a point; numbers, or carrying derivatives where the reference is a
 * field. */
template <typename Number>
struct BasicReferenceMetric
{
  Number A11 = 1., A12 = 0., A22 = 1.;

  /** Area element J_ref = sqrt(det A). */
  Number area_element() const
  {
    using std::sqrt;
    return sqrt(A11 * A22 - A12 * A12);
  }
};

using ReferenceMetric = BasicReferenceMetric<double>;
} // namespace pellicle
