// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/admissible.h>
#include <pellicle/discretization/symmetric_part.h>

#include <limits>

namespace pellicle
{
namespace
{
constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
} // namespace

UnfoldedSurface::UnfoldedSurface(const SurfaceDiscretization &part, const MirrorPlanes &planes)
{
  whole.kind         = part.kind;
  whole.degree       = part.degree;
  whole.tables       = part.tables;
  whole.region_names = part.region_names;
  for (double &weight : whole.tables.weights)
    weight /= planes.n_images();

  // Reflections are sets of coordinates, bit by bit. A node on a plane is its own image.
  const auto is_on = [&](const std::size_t I, const unsigned int c) { return !admits(part.admissible[I], c); };
  std::vector<std::size_t> numbers(8 * part.n_nodes, nowhere);
  const std::size_t k = part.degree;
  for (unsigned int reflection = 0; reflection < 8; ++reflection)
  {
    bool wanted = true, turns_over = false;
    std::array<double, 3> sign{{1., 1., 1.}};
    for (unsigned int c = 0; c < 3; ++c)
      if ((reflection >> c) % 2 == 1)
      {
        wanted     = wanted && planes.normal_to[c];
        turns_over = !turns_over;
        sign[c]    = -1.;
      }
    if (!wanted)
      continue;
    for (std::size_t I = 0; I < part.n_nodes; ++I)
    {
      unsigned int effective = reflection;
      for (unsigned int c = 0; c < 3; ++c)
        if ((reflection >> c) % 2 == 1 && is_on(I, c))
          effective &= ~(1u << c);
      std::size_t &number = numbers[8 * I + effective];
      if (number == nowhere)
      {
        number = images.size();
        images.push_back({I, sign});
      }
      numbers[8 * I + reflection] = number;
    }
    // A reflected cell is inside out; with its two directions exchanged it faces outwards again.
    for (std::size_t cell = 0; cell < part.n_cells; ++cell)
      for (std::size_t j = 0; j <= k; ++j)
        for (std::size_t i = 0; i <= k; ++i)
        {
          const std::size_t local = turns_over ? i * (k + 1) + j : j * (k + 1) + i;
          whole.cell_nodes.push_back(numbers[8 * part.cell_nodes[cell * part.n_local() + local] + reflection]);
        }
    whole.cell_region.insert(whole.cell_region.end(), part.cell_region.begin(), part.cell_region.end());
  }
  whole.n_nodes        = images.size();
  whole.n_cells        = part.n_cells * planes.n_images();
  whole.positions      = values(part.positions, 3);
  whole.mesh_reference = values(part.mesh_reference, 3);
}

std::vector<double> UnfoldedSurface::values(const std::vector<double> &of_part, const unsigned int n_components) const
{
  PELLICLE_ASSERT(n_components == 1 || n_components == 3, "scalars and vectors have images");
  std::vector<double> all;
  all.reserve(n_components * images.size());
  for (const Image &image : images)
    for (unsigned int c = 0; c < n_components; ++c)
      all.push_back((n_components == 3 ? image.sign[c] : 1.) * of_part[n_components * image.node + c]);
  return all;
}
} // namespace pellicle
