// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/refinement.h>
#include <pellicle/discretization/surface_discretization.h>

#include <string>
#include <vector>

namespace pellicle
{
/**
 * An undeformed shell. All but the plate have planes of symmetry, and the mesh is the part between them:
 *
 *     plate       0 <= x <= Length, 0 <= y <= Width, z = 0, n = e_z
 *     cylinder    about z, |z| <= Length/2, open ends; an eighth: x, y, z >= 0
 *     roof        cylindrical, about y, |y| <= Length/2, crown at z = Radius, up to the polar angle `angle` on both
 * sides; a quarter: x, y >= 0 hemisphere  z >= 0, with a hole of the polar angle `angle` around the pole; a quarter: x,
 * y >= 0 sphere      closed; an eighth: x, y, z >= 0
 */
struct ShellShape
{
  std::string name      = "hemisphere";
  double radius         = 1.;
  double length         = 1.;
  double width          = 1.;
  double angle          = 0.; ///< radians
  unsigned int degree   = 3;
  Refinement refinement = 2;
};

/** Names of the shapes. */
const std::vector<std::string> &shell_shape_names();

/** Outward unit normal at a point of the undeformed shell. */
Vector3<double> shell_normal(const ShellShape &shape, const Vector3<double> &place);

/**
 * 4 * 4^r cells (sphere: 12 * 4^r), with one loop around them all, "boundary", planes of symmetry included. Weights of
 * the tables are those of the whole shell: integrals over the mesh are integrals over all its mirror images.
 */
SurfaceDiscretization shell_mesh(const ShellShape &shape);

/** An edge loop of one node with the given weight: what acts at a point. */
EdgeLoop point_loop(const std::string &name, std::size_t node, double weight);

/** The node nearest to a place. */
std::size_t nearest_node(const SurfaceDiscretization &surface, const Vector3<double> &place);
} // namespace pellicle
