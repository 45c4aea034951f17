// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes on meshes that follow the solution, and on uniform ones.
#pragma once

#include "equilibrium_runs.h"

#include <pellicle/models/error_indicators.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace pellicle::test
{
/** A scene with its load: t = 0 at the start, 1 at the end. */
using SceneAlongLoad = std::function<std::unique_ptr<SurfaceScene>(double t)>;

/** How a family of meshes is gone through. */
struct MeshFamily
{
  std::size_t n_levels = 1;
  int load_steps       = 1;    ///< on the first level; the others begin where it ended
  double fraction      = 0.;   ///< of the errors, whose cells are cut; 0: all cells are
  bool is_solved       = true; ///< else shapes stay as they are given
};

struct MeshResult
{
  std::size_t cells = 0, unknowns = 0;
  double energy = 0.; ///< internal units
};

/** One level after the other, each from the solution on the one before. */
class Levels
{
public:
  Levels(SceneAlongLoad scene, const MeshFamily &family)
      : scene_at(std::move(scene))
      , family(family)
  {
  }

  std::vector<MeshResult> run()
  {
    std::vector<MeshResult> results;
    for (std::size_t level = 0; level < family.n_levels; ++level)
    {
      auto next = std::make_unique<SurfaceModel>(*scene(0.), communicator, timing);
      next->update(*scene(1.));
      if (family.is_solved && !(model ? begin_from_last(*next) : walk(*next)))
        break;
      model = std::move(next);
      results.push_back(result());
      choose_next();
    }
    return results;
  }

  const SurfaceModel &finest() const { return *model; }

private:
  std::unique_ptr<SurfaceScene> scene(const double t) const
  {
    std::unique_ptr<SurfaceScene> made = scene_at(t);
    made->mesh.cut                     = cut;
    made->mesh.refinements += further;
    return made;
  }

  bool walk(SurfaceModel &next)
  {
    LoadParameters load;
    load.steps = family.load_steps;
    return walk_load(load,
                     [&](const double t)
                     {
                       next.update(*scene(t));
                       return next.solve(1, record).converged;
                     }) == 1.;
  }

  bool begin_from_last(SurfaceModel &next)
  {
    const bool carried = next.start_from(*model);
    EXPECT_TRUE(carried);
    const StepResult solved = next.solve(1, record);
    EXPECT_TRUE(solved.converged) << solved.failure;
    iterations.push_back(solved.iterations);
    return solved.converged;
  }

  MeshResult result() const
  {
    std::size_t unknowns = 0;
    for (const auto &[field, count] : model->unknown_counts())
      unknowns += count;
    const SurfaceDiscretization &mesh = model->mesh();
    return {mesh.n_cells, family.is_solved ? unknowns : mesh.n_nodes - mesh.hanging.size(),
            model->equilibrium().energy()};
  }

  void choose_next()
  {
    if (family.fraction == 0.)
    {
      ++further;
      return;
    }
    const std::vector<CellPlace> marked =
        cells_with_most(family.fraction, error_indicators(model->equilibrium()), model->mesh().cell_places).places;
    cut.insert(cut.end(), marked.begin(), marked.end());
  }

  SceneAlongLoad scene_at;
  MeshFamily family;
  Communicator communicator;
  Timing timing;
  Record record;
  std::vector<CellPlace> cut;
  int further = 0;
  std::unique_ptr<SurfaceModel> model;

public:
  std::vector<int> iterations; ///< of the levels after the first
};

/** Unknowns with which a relative error is reached for good, between levels by a power law; infinite if it is not. */
inline double unknowns_for(const double error, const double exact, const std::vector<MeshResult> &levels)
{
  const auto error_of = [&](const std::size_t i) { return relative_error(levels[i].energy, exact); };
  std::size_t i       = levels.size();
  while (i > 0 && error_of(i - 1) <= error)
    --i;
  if (i == levels.size())
    return std::numeric_limits<double>::infinity();
  const double after = std::log(static_cast<double>(levels[i].unknowns));
  if (i == 0)
    return std::exp(after);
  const double part   = std::log(error_of(i - 1) / error) / std::log(error_of(i - 1) / error_of(i));
  const double before = std::log(static_cast<double>(levels[i - 1].unknowns));
  return std::exp(before + part * (after - before));
}
} // namespace pellicle::test
