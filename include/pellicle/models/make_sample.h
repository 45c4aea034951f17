// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/models/surface_sample.h>

#include <string>
#include <vector>

namespace pellicle
{
/** A field of the surface's own degree, to be written. */
struct SampledNodalField
{
  std::string name;
  unsigned int n_components = 1; ///< 1 or 3
  std::vector<double> values;    ///< node after node, components together
};

/** Cells round the axis into which each cell of a meridian is revolved. */
constexpr unsigned int default_n_azimuth = 16;

/**
 * What output writes: the surface and fields on it, at equidistant points of every cell.
 *
 * A meridian is revolved: each of its cells becomes `n_azimuth` cells whose points lie exactly on circles about the
 * axis, all cells oriented outwards. Vectors turn with the azimuth. With a mirror plane the lower half is added;
 * scalars are even in z, vectors are reflected. A surface with regions gets the field `region`, their numbers.
 */
SurfaceSample make_sample(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                          const std::vector<SampledNodalField> &fields, unsigned int n_azimuth = default_n_azimuth);
} // namespace pellicle
