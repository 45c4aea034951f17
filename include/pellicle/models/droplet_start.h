// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/models/droplet_scene.h>

namespace pellicle
{
/** A spherical cap that meets a substrate's pole region at a given angle: polar angle of its rim seen from its own
 * centre (0: a flat disc, negative: concave), area, height of the rim's plane, growth of cells away from the rim per
 * radian (see cap()). */
struct StartCap
{
  double rim_angle = 0., area = 0., rim_height = 0., growth = 0.;
};

/**
 * The cap of the given volume on plane or sphere, on a height field that of the plane; none with more than 175 degrees.
 * Its angle is the contact angle without gravity, and with it that of the cap of least energy on a plane, which is near
 * the equilibrium's contact line though not its angle. Throws UserError for a drop that does not fit.
 */
StartCap start_cap(const DropletParameters &droplet, const SubstrateParameters &substrate);

/** The cap's mesh in the user's units, its rim on the substrate and named "contact line". Throws UserError where the
 * substrate is not smooth along the rim. */
SurfaceDiscretization droplet_cap(const DropletScene &scene);

/** Between the plates z = 0 and z = `Plate distance`: arcs that meet both at the contact angle, or a cylinder where
 * there is no such arc. Rims: "contact line", "upper contact line". The user's units. */
SurfaceDiscretization droplet_bridge(const DropletScene &scene);

/** The cap and a flat base below it, regions "liquid gas" and "base". */
SurfaceDiscretization cap_with_base(const DropletScene &scene);

/** A sphere centred at the origin. */
SurfaceDiscretization sphere_of_volume(const DropletScene &scene, double volume);
/** A sphere that stands on z = 0, flattened there (for its weight) and at an upper plate. */
SurfaceDiscretization resting_sphere(const DropletScene &scene);
} // namespace pellicle
