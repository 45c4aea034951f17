// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/vector3.h>

#include <array>
#include <functional>

namespace pellicle
{
/** A closed surface given as a smooth, orientation-preserving map of the unit sphere. */
struct SmoothShape
{
  /** Point of the surface that belongs to a point of the unit sphere. An axisymmetric shape turns about z: the poles
   * stay on the axis, and the half plane y = 0, x >= 0 is mapped into itself. */
  std::function<Vector3<double>(const Vector3<double> &)> point;

  double area   = 0.;
  double volume = 0.;

  bool axisymmetric      = true;
  bool up_down_symmetric = true; ///< under z -> -z, sphere and surface alike

  /** Where the nodes are well spread: on the start shape itself, or on the sphere that it is a map of. */
  enum class EvenMesh
  {
    shape,
    sphere
  };
  EvenMesh even_mesh = EvenMesh::shape;

  /** 3 V/(4 pi (A/4 pi)^(3/2)): 1 for a sphere, less for anything else. */
  double reduced_volume() const;
};

/** The same shape, larger by sqrt(area/shape.area). */
SmoothShape scaled_to_area(const SmoothShape &shape, double area);

/** Ellipsoid with the given semi axes along x, y, z. A = 4 pi R_G(a^2 b^2, a^2 c^2, b^2 c^2) with Carlson's symmetric
 * elliptic integral (DLMF 19.33.1). Throws UserError unless all are positive and finite. */
SmoothShape ellipsoid(const std::array<double, 3> &semi_axes);

/** Spheroid longer along z than across, with the wanted reduced volume (to 1e-14). Throws UserError unless 0 < v < 1.
 */
SmoothShape prolate_spheroid(double reduced_volume);

/** Spheroid shorter along z than across, with the wanted reduced volume (to 1e-14). Throws UserError unless 0 < v < 1.
 */
SmoothShape oblate_spheroid(double reduced_volume);

/** The resting red cell's outline (r, z) = (sin p, (0.1242 + 0.8012 sin^2 p - 0.4492 sin^4 p) cos p), p the polar
 * angle. */
SmoothShape biconcave();

/**
 * A deep cup, nearly closed, mouth upwards (towards +z), made for the wanted reduced volume.
 *
 * Two concentric spheres of radii 1 and R_i < 1 are joined by a rim around a mouth whose half-opening angle, seen from
 * the common centre, is 18 degrees at the tip of the rim. The outline is one smooth curve rather than arcs put
 * together:
 *
 *     radius = R_m + rho eta,  angle from -z = (162 degrees) y,  eta^2 + y^n = 1,  R_m = (1 + R_i)/2,  rho = (1 -
 * R_i)/2,
 *
 * with n such that the tip has the radius of curvature rho. The polar angle of the sphere grows with arc length and, at
 * the rim, faster: nodes crowd where the outline is most curved and the neck narrow.
 *
 * Throws UserError outside the range of v that such cups cover with cells of reasonable shape (0.171 to 0.797).
 */
SmoothShape stomatocyte(double reduced_volume);
} // namespace pellicle
