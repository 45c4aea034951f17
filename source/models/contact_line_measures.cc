// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/models/contact_line_measures.h>
#include <pellicle/models/line_forces.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
ContactLineMeasures measure_contact_line(const SurfaceModel &model, const EdgeLoop &line)
{
  const DropletTargets &drop = model.scene_targets().drop();
  ContactLineMeasures result{0., 180., 0., 0.};
  double length = 0.;
  for (const auto &[node, at] : line_forces(model.equilibrium(), line, drop.chart_of(line.name)))
  {
    const double angle = std::acos(std::clamp(at.pull / (drop.surface_tension * at.length), -1., 1.));
    result.mean += 180. / pi * angle * at.length;
    result.normal_pull += drop.surface_tension * std::sin(angle) * at.length;
    result.smallest = std::min(result.smallest, 180. / pi * angle);
    result.largest  = std::max(result.largest, 180. / pi * angle);
    length += at.length;
  }
  result.mean /= length;
  return result;
}
} // namespace pellicle
