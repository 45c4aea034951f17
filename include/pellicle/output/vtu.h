// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/archive.h>
#include <pellicle/models/surface_sample.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pellicle
{
/**
 * Writes a surface as a compressed VTU file of Lagrange quadrilaterals (VTK cell type 70) of the sample's degree, a
 * body in space as one of Lagrange hexahedra (72): a viewer that subdivides non-linear cells shows the surface itself,
 * not its facets. Point data: `position` (the coordinates once more, so that filters can use them), then the sample's
 * fields; those with three components are vectors, those with nine tensors. Values have single precision, as is
 * customary for pictures. Written as a whole. Throws UserError when the file cannot be written.
 */
void write_vtu(const std::filesystem::path &path, const SurfaceSample &sample);

/** The solutions of one run: `solution_NNNN.vtu` (NNNN the step), `NAME_NNNN.vtu` for each body, and `solution.pvd`,
 * which names them all with their times: the surface as part 0, bodies as parts 1, 2, ... */
class SolutionFiles
{
public:
  /** The directory stands. */
  explicit SolutionFiles(std::filesystem::path output_directory);

  /**
   * Writes the samples and the index anew. `time` is the step's number, the value of the stepped parameter or the place
   * on the load path. Returns the path of the surface's VTU file. Throws UserError as write_vtu() does.
   */
  std::filesystem::path write(const SurfaceSample &sample, int step, double time,
                              const std::vector<NamedSample> &bodies = {});

  /** The list of files. One that is read is that of an earlier run into the directory `of_earlier`: its files are taken
   * from there, others of such names are removed, and the index is written anew. */
  void exchange(Archive &archive, const std::filesystem::path &of_earlier);
  /** The last surface; empty if there is none. */
  std::filesystem::path last() const;

private:
  void write_index() const;

  std::filesystem::path directory;
  struct Part
  {
    double time        = 0.;
    std::size_t number = 0;
    std::string file;

    void exchange(Archive &archive) { archive | time | number | file; }
  };
  std::vector<Part> parts;
};
} // namespace pellicle
