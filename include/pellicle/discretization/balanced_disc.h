// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/refined_quads.h>

namespace pellicle
{
/** A point of the unit disc, in polar coordinates. */
struct DiscPoint
{
  double radius = 0.;
  double cosine = 1., sine = 0.; ///< of the azimuth
};

/**
 * A disc of twelve quadrilaterals, four in the middle (the block) and eight around: two from the centre to the rim.
 *
 * The disc stands for a spherical cap by the azimuthal equidistant projection (polar angle = `angle` times radius; 0:
 * the disc itself). Parameter lines are smooth but for the four sides of the block and the four diagonals from its
 * corners to the rim. There, normal errors of the interpolated surface do not cancel between the two sides, which costs
 * half an order of curvature, unless they vanish to leading order: x^(k+1) along the line must be tangential. It is on
 * circles that are run through at constant speed (k even), hence the block's sides are such circles, and the diagonals
 * such great circles. (k odd: it is small.) At the rim, lines end at right angles, which serves the same purpose.
 */
class BalancedDisc
{
public:
  /** `angle` in [0, pi): the polar angle of the rim. */
  explicit BalancedDisc(double angle);

  /** Quadrilaterals of 17 vertices, counterclockwise: four of the block, then eight around, counterclockwise from
   * azimuth 0. */
  static std::vector<QuadVertices> quads();
  /** Vertex of the rim at azimuth eighth * pi/4. */
  static unsigned int rim_vertex(const unsigned int eighth) { return 9 + eighth % 8; }
  static constexpr unsigned int n_vertices = 17, n_quads = 12;

  double rim_angle() const { return angle; }

  DiscPoint at(unsigned int quad, double u, double v) const;

private:
  /** Side of the block at azimuth 0, in the disc's plane, t in [-1, 1]: x even, y odd. */
  std::array<double, 2> side(double t) const;
  Vector3<double> lifted(double radius, double azimuth_over_pi) const;

  double angle;
  Vector3<double> chord_middle, sagitta_direction; ///< of the circular arc that the side is
  double arc_radius, arc_sagitta, half_arc;
};
} // namespace pellicle
