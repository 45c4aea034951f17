// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/refined_quads.h>

#include <functional>
#include <vector>

namespace pellicle
{
/**
 * A disc of quadrilaterals about the z axis, or its half y >= 0: a core of (n/4)^2 around the axis and rings of n
 * around it. Lines across the rings are straight, along equally spaced meridian planes: nodes of all rings have the
 * same azimuths. n is a multiple of 8, so that a square around the disc has its corners on such lines.
 */
class RidgePlan
{
public:
  /** `n_rings` rings; `n_around` cells in the whole of each. */
  RidgePlan(unsigned int n_around, unsigned int n_rings, bool half);

  /** Distances from the axis as a function of the azimuth: `outline(ring, azimuth over pi)`, ring 0 the core's
   * boundary, whole numbers the lines between rings. */
  using Outline = std::function<double(double ring, double azimuth_over_pi)>;

  /** The disc in z = 0, n = e_z; without rigid motions. */
  SurfaceDiscretization place(const Outline &outline, unsigned int degree) const;

  /** Of each cell of that disc: its ring, 0 the innermost; -1 in the core. */
  std::vector<int> ring_of_cell() const;

  /** Radius of the core's boundary over its mean, a curve between a circle and a square: 1 + 0.2 (t^2 - 1/3), t from -1
   * to 1 between its corners. */
  static double core_outline(double azimuth_over_pi);

private:
  Vector3<double> at(unsigned int patch, double u, double v, const Outline &outline) const;

  unsigned int n_around, n_core; ///< cells around, and along a side of the core
  unsigned int n_core_rows;      ///< of cells, in this half or the whole
  unsigned int n_sectors;        ///< of cells around, in this half or the whole
  unsigned int n_rings;
  std::vector<QuadVertices> quads;
  unsigned int n_vertices = 0;
};
} // namespace pellicle
