// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/base/near_match.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/discretization/surface_quality.h>

#include <algorithm>
#include <limits>
#include <map>

namespace pellicle
{
namespace
{
/** The shapes that are maps of the sphere. To add one: write the map, list it here and in start_shape_names(). */
const std::map<std::string, std::function<SmoothShape(const StartShape &)>> &smooth_shapes()
{
  static const std::map<std::string, std::function<SmoothShape(const StartShape &)>> shapes = {
      {"prolate", [](const StartShape &s) { return prolate_spheroid(s.reduced_volume); }},
      {"oblate", [](const StartShape &s) { return oblate_spheroid(s.reduced_volume); }},
      {"stomatocyte", [](const StartShape &s) { return stomatocyte(s.reduced_volume); }},
      {"ellipsoid", [](const StartShape &s) { return ellipsoid(s.semi_axes); }},
      {"biconcave", [](const StartShape &) { return biconcave(); }},
  };
  return shapes;
}

/** Refuses what the cells are not made for, and meshes that no machine at hand would solve, before memory runs out. */
void check_size(const StartShape &shape)
{
  if (shape.degree < 2 || shape.degree > 5)
    throw UserError("Degree = " + std::to_string(shape.degree) + ": the degree of the cells must be 2, 3, 4 or 5.");
  const unsigned int most = shape.axial ? 16 : 8;
  if (shape.refinements > most)
    throw UserError("Refinements = " + std::to_string(shape.refinements) + ": at most " + std::to_string(most) +
                    " are possible (" + (shape.axial ? "each doubles" : "each makes four times") +
                    " the number of cells). Take a higher degree instead.");
}

/** The open shapes, axial or not. To add one: write its builder, list it here and in open_start_shape_names(). */
const std::map<std::string, std::function<SurfaceDiscretization(const StartShape &)>> &open_shapes()
{
  static const std::map<std::string, std::function<SurfaceDiscretization(const StartShape &)>> shapes = {
      {"cap", [](const StartShape &s) { return cap(s.cap_angle, s.area, s.degree, s.refinement(), s.axial); }},
      {"disc", [](const StartShape &s) { return disc(s.area, s.degree, s.refinement(), s.axial); }},
      {"tube", [](const StartShape &s) { return tube(s.tube_ratio, s.area, s.degree, s.refinement(), s.axial); }},
      {"annulus",
       [](const StartShape &s)
       {
         AnnulusShape ring;
         ring.inner_radius   = s.inner_radius;
         ring.outer_radius   = s.outer_radius;
         ring.smallest       = s.smallest_cell;
         ring.smallest_outer = s.smallest_outer_cell;
         ring.n_radial       = s.radial_cells;
         return annulus(ring, s.degree, s.refinement(), s.axial);
       }},
  };
  return shapes;
}

SurfaceDiscretization build_open(const StartShape &shape)
{
  if (shape.mirror)
    throw UserError("Start shape '" + shape.name + "' is open and has no mirror plane: use the whole meridian.");
  if (shape.region_fraction != 0.)
    throw UserError("Region fraction = " + exact_text(shape.region_fraction) + ": start shape '" + shape.name +
                    "' is open and has no region. Take a closed shape, or set the fraction to 0.");
  return open_shapes().at(shape.name)(shape);
}

SurfaceDiscretization build_axial(const StartShape &shape)
{
  const auto maker = smooth_shapes().find(shape.name);
  if (maker == smooth_shapes().end())
    throw UserError("Start shape '" + shape.name +
                    "' has no axial form: leave the symmetry out, or take an axisymmetric closed shape.");
  const SmoothShape smooth = maker->second(shape);
  if (!smooth.axisymmetric)
    throw UserError("Semi axes = " + exact_text(shape.semi_axes[0]) + ", " + exact_text(shape.semi_axes[1]) + ", " +
                    exact_text(shape.semi_axes[2]) +
                    ": an axial ellipsoid needs the first two to be equal (the axis of revolution is z).");
  if (shape.mirror && !smooth.up_down_symmetric)
    throw UserError("Start shape '" + shape.name + "' has no mirror plane z = 0: use the whole meridian.");
  const SmoothShape scaled = scaled_to_area(smooth, shape.area);
  if (shape.region_fraction == 0.)
    return on_meridian(scaled, shape.degree, shape.refinement(), shape.mirror);
  if (shape.mirror)
    throw UserError("Region fraction = " + exact_text(shape.region_fraction) +
                    ": a region around the north pole has no mirror image. Use the whole meridian.");
  return with_polar_region(scaled, shape.region_fraction, shape.degree, shape.refinement(), true);
}

SurfaceDiscretization build_surface(const StartShape &shape)
{
  if (shape.mirror)
    throw UserError("A mirror plane is possible on a meridian only: ask for axial symmetry as well.");
  if (shape.region_fraction != 0. && smooth_shapes().count(shape.name) == 0)
    throw UserError("Region fraction = " + exact_text(shape.region_fraction) + ": start shape '" + shape.name +
                    "' has no north pole to put a region around. Take a shape without handles, or set the fraction to "
                    "0.");
  if (shape.name == "torus")
    return torus(shape.torus_ratio, shape.area, shape.degree, shape.refinement());
  if (shape.name == "file")
    return from_file(shape.file, shape.area, shape.degree, shape.refinement());
  const SmoothShape scaled = scaled_to_area(smooth_shapes().at(shape.name)(shape), shape.area);
  return shape.region_fraction == 0.
             ? on_cube_sphere(scaled, shape.degree, shape.refinement())
             : with_polar_region(scaled, shape.region_fraction, shape.degree, shape.refinement(), false);
}
} // namespace

const std::vector<std::string> &start_shape_names()
{
  static const std::vector<std::string> names = {"prolate",   "oblate", "stomatocyte", "ellipsoid",
                                                 "biconcave", "torus",  "file"};
  return names;
}

const std::vector<std::string> &open_start_shape_names()
{
  static const std::vector<std::string> names = {"cap", "disc", "tube", "annulus"};
  return names;
}

SurfaceDiscretization make_start_shape(const StartShape &shape)
{
  std::vector<std::string> names = start_shape_names();
  names.insert(names.end(), open_start_shape_names().begin(), open_start_shape_names().end());
  if (std::find(names.begin(), names.end(), shape.name) == names.end())
    throw UserError("Start shape '" + shape.name + "' is not known." + suggestion(shape.name, names));
  if (!(shape.area > 0. && shape.area < std::numeric_limits<double>::infinity()))
    throw UserError("Area = " + exact_text(shape.area) + ": the area of the start shape must be a number > 0.");
  check_size(shape);

  SurfaceDiscretization result = open_shapes().count(shape.name) > 0 ? build_open(shape)
                                 : shape.axial                       ? build_axial(shape)
                                                                     : build_surface(shape);
  check_start_positions(result, "Refine the mesh once more, or take a start shape that is less extreme.");
  return result;
}
} // namespace pellicle
