// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/shell/shell_loads.h>

#include <string>

namespace pellicle
{
namespace
{
const std::string dead_load = "dead load", point_loads = "point loads";

std::shared_ptr<const Potential> point_load(const LoadPoint &point, const double force)
{
  return std::make_shared<DensityPotential<PointLoad>>(point_loads, PointLoad{force * point.direction, point.place},
                                                       Where{Where::Part::edge, point.edge});
}
} // namespace

void DeadLoadParameters::bind(ParameterSection &section)
{
  section.numbers("Force", force, Range::any(), dimensions::pressure,
                  "Force per area of the undeformed shell, three components; it keeps its direction.");
  section.number("Scale", scale, Range::any(), dimensions::none,
                 "Factor on Force, for section Load and for continuation.");
}

const std::string &DeadLoadEffect::name() const
{
  return dead_load;
}

std::string DeadLoadEffect::description() const
{
  return "Dead load of a shell: energy -integral of p . (x - X) over the undeformed shell, p = Scale * f(X, Y) * Force "
         "with the function f in Shell/Load shape.";
}

void DeadLoadEffect::check() const
{
  if (parameters.force.size() != 3)
    throw UserError("Section Dead load: 'Force' has " + std::to_string(parameters.force.size()) +
                    " numbers, three are needed, for example 0, 0, -1.");
}

std::shared_ptr<const Potential> DeadLoadEffect::potential(const Scales &scales, const SceneTargets &targets,
                                                           const double factor) const
{
  const double unit = factor / scales.of(dimensions::pressure);
  DeadLoad load;
  load.force     = unit * Vector3<double>(parameters.force[0], parameters.force[1], parameters.force[2]);
  load.shape     = targets.shell_targets().load_shape;
  load.reference = targets.shell_targets().reference;
  return std::make_shared<DensityPotential<DeadLoad>>(dead_load, load);
}

std::vector<ParameterDerivative> DeadLoadEffect::derivatives(const Scales &scales, const SceneTargets &targets) const
{
  return {{"Dead load/Scale", potential(scales, targets, 1.), "", 0.}};
}

void DeadLoadEffect::contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const
{
  set.energies.push_back(potential(scales, targets, parameters.scale));
}

void PointLoadParameters::bind(ParameterSection &section)
{
  section.number("Force", force, Range::any(), {1, -1},
                 "Force F at every load point of the whole shell, in the direction that Shell/Shape gives to it.");
}

const std::string &PointLoadsEffect::name() const
{
  return point_loads;
}

std::string PointLoadsEffect::description() const
{
  return "Point loads of a shell: energy -F e . (x - X) at every load point of its shape, e their directions: pairs of "
         "equal and opposite forces.";
}

std::vector<ParameterDerivative> PointLoadsEffect::derivatives(const Scales &scales, const SceneTargets &targets) const
{
  std::vector<ParameterDerivative> list;
  for (const LoadPoint &point : targets.shell_targets().load_points)
    list.push_back({"Point loads/Force", point_load(point, 1. / scales.of({1, -1})), "", 0.});
  return list;
}

void PointLoadsEffect::contribute(const Scales &scales, const SceneTargets &targets, PotentialSet &set) const
{
  for (const LoadPoint &point : targets.shell_targets().load_points)
    set.energies.push_back(point_load(point, scaled(parameters, scales).force));
}
} // namespace pellicle
