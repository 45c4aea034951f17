// SPDX-License-Identifier: LGPL-2.1-or-later
// Blocks that are pressed against something, with contact by pair terms.
#pragma once

#include "body_runs.h"

#include <pellicle/assembly/contact_pairs.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/joined.h>
#include <pellicle/models/contact_augmentation.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pellicle::test
{
/** A block turned about the x axis, so that its surface, the face "top", looks down at z = `height`. */
inline SurfaceDiscretization hanging_block(const std::string &name, const BlockShape &shape, const unsigned int degree,
                                           const double height)
{
  SurfaceDiscretization result = block(name, shape, degree);
  for (std::size_t I = 0; I < result.n_nodes; ++I)
  {
    result.positions[3 * I + 1] = shape.y.front() + shape.y.back() - result.positions[3 * I + 1];
    result.positions[3 * I + 2] = height + shape.z.back() - result.positions[3 * I + 2];
  }
  result.mesh_reference = result.positions;
  return result;
}

inline std::shared_ptr<const Potential> solid_of(const SurfaceDiscretization &all, const std::size_t body,
                                                 const NeoHookeanSolid &law)
{
  const BulkPart &part = all.bulks[body];
  return std::make_shared<DensityPotential<ElasticBody<NeoHookeanSolid>>>(
      "solid",
      ElasticBody<NeoHookeanSolid>{
          law, std::make_shared<const std::vector<ReferenceBasis>>(reference_bases(part, all.positions))},
      Where{Where::Part::bulk, part.name});
}

/** Some cells of a surface with the nodes that they have, and their rims, named "rim". */
inline SurfaceDiscretization part_of(const SurfaceDiscretization &whole, const std::function<bool(std::size_t)> &wanted,
                                     const unsigned int n_gauss)
{
  SurfaceDiscretization part;
  part.degree = whole.degree;
  part.tables = make_surface_tables(whole.degree, n_gauss);
  std::map<std::size_t, std::size_t> number;
  for (std::size_t c = 0; c < whole.n_cells; ++c)
  {
    if (!wanted(c))
      continue;
    ++part.n_cells;
    for (std::size_t i = 0; i < whole.n_local(); ++i)
    {
      const std::size_t node     = whole.cell_nodes[c * whole.n_local() + i];
      const auto [found, is_new] = number.emplace(node, number.size());
      part.cell_nodes.push_back(found->second);
      if (is_new)
        part.positions.insert(part.positions.end(), whole.positions.begin() + 3 * node,
                              whole.positions.begin() + 3 * node + 3);
    }
  }
  part.n_nodes        = number.size();
  part.mesh_reference = part.positions;
  part.edges          = find_rims(part, [](const Vector3<double> &) { return std::string("rim"); });
  return part;
}

/** Residuals of Newton's iterations. */
class ResidualRecord : public Observer
{
public:
  void on_iteration(const IterationReport &report) override { residuals.push_back(report.relative_residual); }
  std::vector<double> residuals;
};

struct AugmentedResult
{
  bool converged = false;
  int iterations = 0, augmentations = 0;
  int last_iterations = 0;       ///< of the last equilibrium
  std::vector<double> residuals; ///< of the first equilibrium
  std::string failure;
};

/** Equilibria and augmentations in turn. */
inline AugmentedResult solve_with_pairs(BodyRun &run, const double tolerance, const int most = 40)
{
  AugmentedResult all;
  ContactAugmentation outer(run.problem.pairs(), tolerance);
  for (; all.augmentations < most; ++all.augmentations)
  {
    ResidualRecord record;
    const NewtonResult result = Newton(run.parameters, *run.solver, run.timing).solve(run.problem, 0, record);
    all.iterations += result.iterations;
    all.last_iterations = result.iterations;
    all.failure         = result.failure;
    if (all.augmentations == 0)
      all.residuals = record.residuals;
    if (!result.converged)
      return all;
    if (outer.update(run.problem) == 0)
    {
      all.converged = true;
      return all;
    }
  }
  all.failure = "augmentations do not converge";
  return all;
}

inline double force_along_z(const NodalVectors &forces, const std::vector<std::size_t> &nodes)
{
  double sum = 0.;
  for (const std::size_t I : nodes)
    sum += forces[3 * I + 2];
  return sum;
}
} // namespace pellicle::test
