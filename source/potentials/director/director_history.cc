// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/director/director_history.h>

namespace pellicle
{
std::vector<DirectorHistory> isotropic_history(const std::vector<DirectorPoint> &points, const double B)
{
  std::vector<DirectorHistory> history;
  history.reserve(points.size());
  for (const DirectorPoint &point : points)
  {
    const Vector3<double> d = point.O / norm(point.O);
    const auto b            = [&](const Vector3<double> &x_a) { return B * (x_a - dot(d, x_a) * d); };
    history.push_back({{point.x_1, point.x_2, d}, {b(point.x_1), b(point.x_2)}});
  }
  return history;
}

void transport(std::vector<DirectorHistory> &history, const std::vector<DirectorPoint> &now)
{
  PELLICLE_ASSERT(history.size() == now.size(), "One state for each point of the history.");
  for (std::size_t q = 0; q < history.size(); ++q)
  {
    const Vector3<double> d = now[q].O / norm(now[q].O);
    history[q].b            = transported(history[q], TangentPlane<double>(now[q].x_1, now[q].x_2), d);
    history[q].at           = {now[q].x_1, now[q].x_2, d};
  }
}
} // namespace pellicle
