// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <map>
#include <vector>

namespace pellicle
{
/** Value of a density per length at a node of a line, and the length that the node stands for. */
struct LineDensity
{
  double value  = 0.;
  double length = 0.;
};

/** The density q = sum q_I N_I on a line whose integrals with the shape functions N_I are given by node. */
std::vector<LineDensity> density_along_line(const EdgeLoop &line, const NodalVectors &positions,
                                            const std::map<std::size_t, double> &integrals);
} // namespace pellicle
