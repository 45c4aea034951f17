// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_sample.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/**
 * Writes a surface as a compressed VTU file of Lagrange quadrilaterals (VTK cell type 70) of the sample's degree: a
 * viewer that subdivides non-linear cells shows the surface itself, not its facets. Point data: `position` (the
 * coordinates once more, so that filters can use them), then the sample's fields; those with three components are
 * vectors. Values have single precision, as is customary for pictures. Written as a whole. Throws UserError when the
 * file cannot be written.
 */
void write_vtu(const std::filesystem::path &path, const SurfaceSample &sample);

/** The solutions of one run: `solution_NNNN.vtu` (NNNN the step) and `solution.pvd`, which names them all with their
 * times. */
class SolutionFiles
{
public:
  /** The directory stands. */
  explicit SolutionFiles(std::filesystem::path output_directory);

  /**
   * Writes the sample and the index anew. `time` is the step's number or the value of the stepped parameter. Returns
   * the path of the VTU file. Throws UserError as write_vtu() does.
   */
  std::filesystem::path write(const SurfaceSample &sample, int step, double time);

private:
  std::filesystem::path directory;
  std::vector<std::pair<double, std::string>> times_and_names;
};
} // namespace pellicle
