// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/ridge_mesh.h>

#include <array>
#include <vector>

namespace pellicle
{
/** Throws UserError for shapes that axial_ridge() and ridge_in_space() refuse alike. */
void check_ridge(const RidgeShape &shape);

/**
 * Ends of cells on [0, length], ascending, the first of about `size` (never larger): each is `growth` times as large as
 * the one before it at most, and none is larger than `coarsest` times its distance from 0 or than `largest`, whichever
 * is more.
 */
std::vector<double> graded_ends(double length, double size, double growth, double coarsest, double largest);

/** graded_ends() of the shape's own numbers, for cells of another size at the ring. */
std::vector<double> graded_ends(double length, double size, const RidgeShape &shape);

/** from - ends (descending input, ascending result): cells graded towards `from` from below. */
std::vector<double> downwards(double from, const std::vector<double> &ends);

/** Gauss points of the cells of substrate and surfaces along each direction. At the line strains are singular, and with
 * as few as degree + 1 points a cell there turns inside out between them and lowers its energy: the surface folds, in
 * space at a size of .0125 ring radii under the tensions of Sauer 2014 (doc/numerics.md, "Wetting ridges"). */
constexpr unsigned int substrate_points(const unsigned int degree)
{
  return degree + 3;
}

/** The spherical cap of a drop as a function of the distance from the axis: polar angle = (rim's) rho, rho = 1 at the
 * ring. */
class CapOutline
{
public:
  explicit CapOutline(const RidgeShape &shape);

  /** (r, z); exactly (ring_radius, 0) for rho = 1. */
  std::array<double, 2> at(double rho) const;
  /** Polar angle of the ring. */
  double angle() const { return rim_angle; }
  /** Length of its meridian. */
  double arc() const { return radius * rim_angle; }

private:
  double ring_radius, rim_angle, radius;
};
} // namespace pellicle
