// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes on meshes that follow the solution, and on uniform ones.
#pragma once

#include "equilibrium_runs.h"

#include <pellicle/models/error_indicators.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace pellicle::test
{
struct MeshResult
{
  std::size_t cells = 0, nodes = 0;
  double value      = 0.;
  double indicators = 0.; ///< their sum
};

/** Solves a model, or leaves it as it was built: then only what is eliminated is known. */
using Solve = std::function<void(SurfaceModel &)>;

inline void as_built(SurfaceModel &)
{
}

inline double sum_of(const std::vector<double> &numbers)
{
  double sum = 0.;
  for (const double number : numbers)
    sum += number;
  return sum;
}

/** Level after level: solved, then the cells with the given share of the errors are cut. */
template <typename Scene>
std::vector<MeshResult> adaptively(Scene scene, const std::size_t n_levels, const double fraction, const Solve &solve)
{
  std::vector<MeshResult> results;
  Communicator communicator;
  Timing timing;
  while (results.size() < n_levels)
  {
    SurfaceModel model(scene, communicator, timing);
    solve(model);
    const std::vector<double> indicators = error_indicators(model.equilibrium());
    results.push_back({model.mesh().n_cells, model.mesh().n_nodes, model.equilibrium().energy(), sum_of(indicators)});
    const auto marked = cells_with_most(fraction, indicators, model.mesh().cell_places);
    scene.mesh.cut.insert(scene.mesh.cut.end(), marked.begin(), marked.end());
  }
  return results;
}

template <typename Scene>
std::vector<MeshResult> uniformly(Scene scene, const std::size_t n_levels, const Solve &solve)
{
  std::vector<MeshResult> results;
  Communicator communicator;
  Timing timing;
  for (; results.size() < n_levels; ++scene.mesh.refinements)
  {
    SurfaceModel model(scene, communicator, timing);
    solve(model);
    results.push_back({model.mesh().n_cells, model.mesh().n_nodes, model.equilibrium().energy(),
                       sum_of(error_indicators(model.equilibrium()))});
  }
  return results;
}

/** Nodes with which a relative error is reached, between levels by a power law; infinite if it never is. */
inline double nodes_for(const double error, const double exact, const std::vector<MeshResult> &levels)
{
  const auto error_of = [&](const MeshResult &level) { return relative_error(level.value, exact); };
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (error_of(levels[i]) <= error)
    {
      if (i == 0)
        return static_cast<double>(levels[0].nodes);
      const double part =
          std::log(error_of(levels[i - 1]) / error) / std::log(error_of(levels[i - 1]) / error_of(levels[i]));
      return std::exp((1. - part) * std::log(levels[i - 1].nodes) + part * std::log(levels[i].nodes));
    }
  return std::numeric_limits<double>::infinity();
}
} // namespace pellicle::test
