// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/function_of_place.h>
#include <pellicle/potentials/shell/shell_reference.h>

#include <memory>
#include <string>
#include <vector>

namespace pellicle
{
/** A point of a shell on which a force may act: an edge loop of one node, and what the scene says of it. */
struct LoadPoint
{
  std::string edge;          ///< name of the loop, whose weight is the number of such points on the whole shell
  Vector3<double> direction; ///< unit vector
  Vector3<double> place;     ///< X
};

/** What the effects of shells take from the scene, internal units. */
struct ShellTargets
{
  /** The undeformed shell at its quadrature points; null while a scene is only checked. */
  std::shared_ptr<const std::vector<ShellReference>> reference = nullptr;
  std::vector<LoadPoint> load_points                           = {};
  /** Factor on a dead load, of the place X, Y; null: 1. */
  std::shared_ptr<const FunctionOfPlace> load_shape = nullptr;
};
} // namespace pellicle
