// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/constants.h>
#include <pellicle/discretization/refinement.h>
#include <pellicle/discretization/surface_discretization.h>

#include <functional>
#include <string>
#include <vector>

namespace pellicle
{
/** Sections "Mesh" and the part of "Vesicle" that makes the start shape; lengths in the user's units. */
struct StartShape
{
  std::string name      = "prolate"; ///< see start_shape_names()
  double area           = 4. * pi;
  double reduced_volume = 0.95;
  std::array<double, 3> semi_axes{{1., 1., 1.}}; ///< `ellipsoid`
  double torus_ratio = 1.4142135623730951;       ///< R/r of `torus`
  std::string file;                              ///< `file`: Gmsh MSH 4.1

  double cap_angle           = 0.5 * pi; ///< `cap`: polar angle of the rim in radians
  double tube_ratio          = 4.;       ///< `tube`: length/radius
  double inner_radius        = 0.1;      ///< `annulus`, which has no use of `area`
  double outer_radius        = 1.;       ///< `annulus`
  double smallest_cell       = 0.;       ///< `annulus`: size of the cells at the inner rim, as refined; 0: not graded
  double smallest_outer_cell = 0.;       ///< `annulus`: the same at the outer rim
  unsigned int radial_cells  = 8;        ///< `annulus`: between the rims on the coarsest mesh

  double region_fraction = 0.; ///< area of region "domain" (see with_polar_region()) over `area`; 0: no region

  unsigned int degree      = 3;
  unsigned int refinements = 2;
  std::vector<CellPlace> cut; ///< further; see Refinement
  bool axial  = false;        ///< a meridian instead of a surface
  bool mirror = false;        ///< axial only: half a meridian, mirror plane z = 0

  Refinement refinement() const { return {refinements, cut}; }
};

/** The closed ones: prolate, oblate, stomatocyte, ellipsoid, biconcave, torus, file. */
const std::vector<std::string> &start_shape_names();
/** cap, disc, tube, annulus. */
const std::vector<std::string> &open_start_shape_names();

/**
 * Builds mesh, nodes and tables of a start shape, scaled to `area` (exact area of the smooth shape; a file: area of the
 * rounded mesh). Closed surfaces start from the 6 cells of a cube projected on it, each refinement makes four of one: 6
 * * 4^r cells. A meridian has 4 * 2^r cells from pole to pole (2 * 2^r to the mirror plane). Cells of open surfaces and
 * of surfaces with a region: see builders.h.
 *
 * Throws UserError: unknown shape (with near matches), degree outside 2 to 5, too many refinements, v outside (0, 1)
 * for the shapes made from v (stomatocyte: outside 0.171 to 0.797), v = 1 exactly (a sphere: area and volume
 * constraints have parallel gradients), non-positive numbers, a shape that has no axial form, no mirror plane or cannot
 * have a region, sizes that the builders refuse, a mesh that is missing, malformed, open or not orientable.
 */
SurfaceDiscretization make_start_shape(const StartShape &shape);
} // namespace pellicle
