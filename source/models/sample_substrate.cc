// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/models/sample_substrate.h>
#include <pellicle/models/surface_model.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double margin       = 1.5; // of the square's half side over the drop's distance from the axis
constexpr unsigned int n_side = 24;  // cells along a side
constexpr unsigned int degree = 3;
} // namespace

SurfaceSample sample_substrate(const SurfaceModel &model)
{
  const NodalVectors positions = model.positions();
  double reach                 = 0.;
  for (std::size_t I = 0; I < model.mesh().n_nodes; ++I)
    reach = std::max(reach, std::hypot(positions[3 * I], positions[3 * I + 1]));

  SurfaceSample sample;
  sample.degree  = degree;
  const auto add = [&](const auto &chart)
  {
    const double step = 2. * margin * reach / n_side;
    for (unsigned int c = 0; c < n_side * n_side; ++c)
      for (unsigned int p = 0; p < (degree + 1) * (degree + 1); ++p)
      {
        const double u          = (c % n_side + double(p % (degree + 1)) / degree) * step - margin * reach,
                     v          = (c / n_side + double(p / (degree + 1)) / degree) * step - margin * reach;
        const Vector3<double> x = chart.at(u, v).place;
        for (unsigned int i = 0; i < 3; ++i)
          sample.points.push_back(x[i] * model.scales().length);
      }
    sample.n_cells += n_side * n_side;
  };
  for (const SubstrateChart &chart : model.scene_targets().drop().walls)
    std::visit(add, chart);
  return sample;
}
} // namespace pellicle
