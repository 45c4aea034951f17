// SPDX-License-Identifier: LGPL-2.1-or-later
// Solves a problem with bodies from given positions.
#pragma once

#include <pellicle/assembly/body_nodes.h>
#include <pellicle/base/observer.h>
#include <pellicle/discretization/bodies.h>
#include <pellicle/models/surface_problem.h>
#include <pellicle/potentials/solids/neo_hookean_solid.h>
#include <pellicle/solvers/newton.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pellicle::test
{
inline const Where in_body{Where::Part::bulk, "body"};

inline std::shared_ptr<const std::vector<ReferenceBasis>> reference_of(const SurfaceDiscretization &body)
{
  return std::make_shared<const std::vector<ReferenceBasis>>(reference_bases(body.bulks[0], body.positions));
}

inline std::shared_ptr<const Potential> solid(const SurfaceDiscretization &body, const NeoHookeanSolid &law)
{
  return std::make_shared<DensityPotential<ElasticBody<NeoHookeanSolid>>>(
      "solid", ElasticBody<NeoHookeanSolid>{law, reference_of(body)}, in_body);
}

/** A problem in the material chart, and Newton's method on it. */
class BodyRun
{
public:
  BodyRun(const SurfaceDiscretization &discretization, PotentialSet set, NodalConditions conditions)
      : problem(discretization, std::move(set), std::move(conditions), communicator, parameters.linear_solver, timing)
      , solver(make_linear_solver(parameters.linear_solver))
  {
    parameters.initial_drag = 0.;
    problem.use_chart(PositionChart::material, {});
  }

  void place(NodalVectors positions)
  {
    SurfaceState state = problem.state();
    state.fields[0]    = std::move(positions);
    problem.set_state(std::move(state));
  }

  NewtonResult solve()
  {
    Observer nobody;
    return Newton(parameters, *solver, timing).solve(problem, 0, nobody);
  }

  const NodalVectors &positions() const { return problem.state().fields[0]; }

  NewtonParameters parameters;
  Communicator communicator;
  Timing timing;
  SurfaceProblem problem;
  std::unique_ptr<LinearSolver> solver;
};
} // namespace pellicle::test
