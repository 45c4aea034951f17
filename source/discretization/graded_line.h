// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace pellicle
{
/**
 * n cells on [0, length] whose sizes grow geometrically away from one end or from both: size h(x) with 1/h = 1/(s_1 + q
 * x) + 1/(s_2 + q (length - x)), where q follows from the number of cells, integral of dx/h = n. A size of 0 stands for
 * an end without grading (its term is left out); both 0: cells of equal size.
 */
class GradedLine
{
public:
  /** `first`, `last`: sizes of the cells at the ends; neither may exceed length/n. With only one of them it is exact,
   * with both about so. */
  GradedLine(double length, double n_cells, double first, double last);

  /** Position of t in [0, n]; whole numbers are the ends of cells. */
  double at(double t) const;

  /** Factor by which sizes of neighbours differ at most. */
  double growth() const;

private:
  double length, n_cells;
  double rate        = 0.;                  ///< q; 0: cells of equal size
  double first_slope = 0., last_slope = 0.; ///< q/s_1 and q/s_2
};
} // namespace pellicle
