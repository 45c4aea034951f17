// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/ridge_mesh.h>

#include <cstddef>
#include <vector>

namespace pellicle
{
/**
 * The lines of a substrate's mesh that run from the axis past the contact line to the side. Right below the contact
 * line they are graded towards it; from there they fan out, straight, to columns of coarse cells: the material near the
 * outer edge, on which the skin pulls as it does on the contact line, would fold where cells are thin.
 */
class RidgeFan
{
public:
  /** `inwards`: distance from the contact line towards the axis at which cells are as coarse as they get. */
  RidgeFan(const RidgeShape &shape, double inwards);

  /** Ends of the cells right below the contact line, ascending. */
  const std::vector<double> &column() const { return below_line; }
  std::size_t n_levels() const { return levels.size(); }
  /** Height of a level of nodes, the lowest being 0, at a distance from the axis. */
  double height(std::size_t level, double r) const;

private:
  struct Level
  {
    double below_line, far_away;
  };
  double ring_radius, inwards, outwards;
  std::vector<double> below_line;
  std::vector<Level> levels;
};
} // namespace pellicle
