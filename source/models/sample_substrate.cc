// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/constants.h>
#include <pellicle/models/sample_substrate.h>
#include <pellicle/models/surface_model.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double margin         = 1.3; // of the disc's radius over the drop's distance from the axis
constexpr unsigned int n_across = 12, n_around = 24;
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
    for (unsigned int c = 0; c < n_across * n_around; ++c)
      for (unsigned int p = 0; p < (degree + 1) * (degree + 1); ++p)
      {
        const double rho        = margin * reach / n_across * (c % n_across + double(p % (degree + 1)) / degree),
                     phi        = 2. * pi / n_around * (c / n_across + double(p / (degree + 1)) / degree);
        const Vector3<double> x = chart.at(rho * std::cos(phi), rho * std::sin(phi)).place;
        for (unsigned int i = 0; i < 3; ++i)
          sample.points.push_back(x[i] * model.scales().length);
      }
    sample.n_cells += n_across * n_around;
  };
  for (const SubstrateChart &chart : model.scene_targets().drop().walls)
    std::visit(add, chart);
  return sample;
}
} // namespace pellicle
