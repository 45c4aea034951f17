// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/parameters.h>
#include <pellicle/models/error_indicators.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pellicle
{
/** Section "Accuracy". */
struct AccuracyParameters
{
  double target    = 0.; ///< relative error of the scene's headline quantity; 0: the scene's own mesh, no estimate
  int max_levels   = 16;
  int max_unknowns = 200000;
  std::string refinement = "uniform";

  bool is_wanted() const { return target > 0.; }
  void bind(ParameterSection &section);
};

/** How fine the mesh of a level is: the numbers of section Mesh, and the cells that are cut further. */
struct LevelMesh
{
  unsigned int degree        = 2;
  unsigned int refinements   = 1;
  std::vector<CellPlace> cut = {}; ///< see Refinement
};

/** Where a scene begins, and how far its meshes go, when an accuracy is asked for. */
struct LevelRange
{
  LevelMesh first;
  unsigned int highest_degree   = 5; ///< the first level's: the mesh is refined only
  unsigned int most_refinements = 8;
  unsigned int dimension        = 2; ///< of the cells that are refined: 1 on a meridian
};

/** A level that was solved. */
struct LevelRecord
{
  LevelMesh mesh;
  std::size_t n_cells = 0, n_unknowns = 0;
  double value = 0.;           ///< of the headline quantity
  std::optional<double> error; ///< estimated, relative to the value; none while there is no finer level
  WorstCells worst = {};       ///< where cells may be cut in places
};

/**
 * A way to the mesh of the next level.
 *
 * Which one is taken is a matter of promises: by how many powers of the work a way lowers the error. To add one, derive
 * from this class and list it in ways_to_refine().
 */
class NextMesh
{
public:
  virtual ~NextMesh() = default;
  /** None where meshes end. */
  virtual std::optional<LevelMesh> after(const LevelRecord &level, const LevelRange &range) const = 0;
  /** log(error before/error after)/log(work after/work before), as measured when this way was last taken, or as smooth
   * solutions behave. */
  virtual double promise(const std::vector<LevelRecord> &levels, const LevelRange &range) const = 0;
};

/** All ways: a higher degree; all cells cut; the cells with the largest errors cut. */
std::vector<std::unique_ptr<NextMesh>> ways_to_refine();

/** The mesh after the last level by the way that promises most; none if no way is left. */
std::optional<LevelMesh> next_level(const std::vector<LevelRecord> &levels, const LevelRange &range);

/** About how many unknowns a mesh has, from those of a level. */
double expected_unknowns(const LevelRecord &level, const LevelMesh &next, const LevelRange &range);
} // namespace pellicle
