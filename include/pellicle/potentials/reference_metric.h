// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace pellicle
{
/** Metric A_ab of a reference parametrisation at a point. */
struct ReferenceMetric
{
  double A11 = 1., A12 = 0., A22 = 1.;

  /** Area element J_ref = sqrt(det A). */
  double area_element() const { return std::sqrt(A11 * A22 - A12 * A12); }
};
} // namespace pellicle
