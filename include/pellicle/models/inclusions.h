// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/parameters.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/discretization/surface_discretization.h>

#include <string>
#include <vector>

namespace pellicle
{
/** Section "Inclusion": rigid discs in a membrane, at whose rims the directors are tilted. The user's units. */
struct InclusionParameters
{
  double radius       = 1.;
  double outer_radius = 20.;
  double edge_tilt    = 0.5;
  double distance     = 6.;
  std::string second  = "alike";
  double polar_angle  = 0.2;

  void bind(ParameterSection &section);
  /** Throws UserError for discs that do not fit the membrane of the given value of Surface/Shape, in a mesh of the
   * given Mesh/Symmetry. */
  void check(const std::string &shape, const std::string &symmetry) const;
};

/** Values of Surface/Shape with inclusions. */
const std::vector<std::string> &inclusion_shape_names();
bool has_inclusions(const std::string &shape);

/** A membrane around inclusions, in the user's units. */
struct InclusionMembrane
{
  std::string shape; ///< one of inclusion_shape_names()
  InclusionParameters discs;
  double decay_length = 1.; ///< of tilt, sqrt(K/k_t)

  bool is_flat() const;

  /** Rims of the mesh: those at inclusions first, then the outer one. */
  std::vector<std::string> rims() const;

  /** Of the membrane, without inclusions. sphere_area: with the part that is cut away. */
  double area(double sphere_area) const;

  /**
   * A flat ring, a flat disc with two holes, or a sphere of area `base.area` (the part cut away included) without the
   * cap of the given polar angle around its lowest point. Degree, refinements and symmetry are those of `base`. Cells
   * grow from the inclusions, where they are smaller than both the decay length of tilt and the radius.
   */
  SurfaceDiscretization mesh(const StartShape &base) const;

  /**
   * Tilts directors away from the inclusions: at their rims by the edge tilt from the exact normals, elsewhere by an
   * estimate of its decay, sqrt(a/(a + s)) exp(-s/l) at the distance s. At an outer rim they become the normals.
   */
  void tilt(const SurfaceDiscretization &surface, const StartShape &base, NodalVectors &directors) const;
};
} // namespace pellicle
