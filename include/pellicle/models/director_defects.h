// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <optional>
#include <vector>

namespace pellicle
{
class SurfaceModel;

/** A point around which directors lie in the surface and turn, as often as `charge` says: +1 where all of them point
 * away from it, or run round it, -1 at a saddle. */
struct Defect
{
  Vector3<double> position;
  int charge = 0;
};

/**
 * Defects of the tangential parts t = O - (O.n) n of unit directors: zeros of t by the number of turns t makes around
 * them, counterclockwise seen from outside. On a closed surface whose directors lie in it away from a few cores, the
 * charges add up to the Euler characteristic (Poincare & Hopf).
 *
 * A core is a connected part of the surface with |t| < 1/2 at its nodes, or where t turns round within a patch of four
 * nodes; it is a defect if t turns along its edge, and stands at the centre of 1 - |t|^2. So neither nodes that carry
 * a zero exactly nor noise matters: t is only followed between nodes where it is long. No core can be told at rims
 * where directors leave the surface, nor if its edge is nowhere. On a meridian only the axis has points, those of
 * charge +1; zeros elsewhere are circles.
 *
 * None at all (not even an empty list) if |t| < 1/2 everywhere: such directors are tilted normals.
 */
std::optional<std::vector<Defect>> director_defects(const SurfaceDiscretization &surface, const NodalVectors &positions,
                                                    const NodalVectors &directors);

/** Of a model, in internal units; none if it has no directors. */
std::optional<std::vector<Defect>> director_defects(const SurfaceModel &model);
} // namespace pellicle
