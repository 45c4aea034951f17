// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/discretization/admissible.h>

#include <cmath>

namespace pellicle
{
AdmissibleDirections admissible_at(const SurfaceDiscretization &discretization, const std::size_t node)
{
  return discretization.admissible.empty() ? AdmissibleDirections{} : discretization.admissible[node];
}

Vector3<double> admissible_part(const AdmissibleDirections &directions, const Vector3<double> &v)
{
  Vector3<double> part;
  for (unsigned int j = 0; j < directions.count; ++j)
  {
    const Vector3<double> e(directions.columns[j][0], directions.columns[j][1], directions.columns[j][2]);
    part += dot(v, e) * e;
  }
  return part;
}

bool admits(const AdmissibleDirections &directions, const unsigned int component)
{
  double part = 0.;
  for (unsigned int j = 0; j < directions.count; ++j)
    part += std::pow(directions.columns[j][component], 2);
  return part > 0.5;
}
} // namespace pellicle
