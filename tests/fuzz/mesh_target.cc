// SPDX-License-Identifier: LGPL-2.1-or-later
// A Gmsh file becomes a closed surface of curved cells.
#include "memory_file.h"
#include "targets.h"

#include <pellicle/discretization/builders.h>

#include <cmath>

namespace pellicle::fuzz
{
void read_mesh(const std::string &input)
{
  const MemoryFile file(input);
  constexpr double area                      = 1.;
  constexpr unsigned int degree              = 2;
  const SurfaceDiscretization discretization = from_file(file.name(), area, degree, 0);
  for (const double coordinate : discretization.positions)
    if (!std::isfinite(coordinate))
      throw std::logic_error("an accepted mesh has nodes nowhere");
}
} // namespace pellicle::fuzz
