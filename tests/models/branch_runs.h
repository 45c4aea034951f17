// SPDX-License-Identifier: LGPL-2.1-or-later
// Branches of equilibria for the tests.
#pragma once

#include "equilibrium_runs.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pellicle::test
{
/** A scene with a value of the parameter that is varied. */
using SceneAt = std::function<VesicleScene(double)>;

class Messages : public Observer
{
public:
  void on_message(const std::string &text) override { texts.push_back(text); }
  bool mention(const std::string &part) const
  {
    for (const std::string &text : texts)
      if (text.find(part) != std::string::npos)
        return true;
    return false;
  }
  std::vector<std::string> texts;
};

/** A branch that was followed from the equilibrium at a value of its parameter. */
class Followed
{
public:
  struct Point
  {
    double parameter = 0.;
    bool is_fold     = false;
    std::optional<int> negative_eigenvalues;
    double energy = 0.; ///< internal units
    NodalVectors positions;
    ShapeMeasures shape;
  };

  Followed(const SceneAt &scene_at, const double start, const BranchParameters &branch)
      : model(scene_at(start), communicator, timing)
  {
    const StepResult first = model.solve(0, messages);
    if (!first.converged)
    {
      result.failure = "no equilibrium at the start: " + first.failure;
      return;
    }
    const auto scene = [&](const double p) { return std::make_unique<VesicleScene>(scene_at(p)); };
    result           = model.follow_branch(branch, start, scene, messages,
                                           [&](const SurfaceModel::PointOnBranch &here)
                                           {
                                   const NodalVectors &positions = model.equilibrium().state().fields[0];
                                   points.push_back({here.point.parameter, here.point.is_fold,
                                                     here.negative_eigenvalues, model.equilibrium().energy(), positions,
                                                     measure_shape(model.mesh(), positions)});
                                 });
  }

  std::vector<Point> folds() const
  {
    std::vector<Point> list;
    for (const Point &point : points)
      if (point.is_fold)
        list.push_back(point);
    return list;
  }

  Communicator communicator;
  Timing timing;
  Messages messages;
  SurfaceModel model;
  ContinuationResult result;
  std::vector<Point> points;
};

inline BranchParameters branch_along(const std::string &parameter, const std::string &direction, const double lower,
                                     const double upper)
{
  BranchParameters branch;
  branch.parameter   = parameter;
  branch.direction   = direction;
  branch.steps.lower = lower;
  branch.steps.upper = upper;
  return branch;
}
} // namespace pellicle::test
