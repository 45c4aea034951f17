// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/discretization/sheets.h>

#include <algorithm>
#include <map>
#include <utility>

namespace pellicle
{
std::vector<double> Sheets::values(const std::vector<double> &of_whole, const unsigned int n_components) const
{
  std::vector<double> list;
  list.reserve(n_components * original.size());
  for (const std::size_t node : original)
    list.insert(list.end(), of_whole.begin() + static_cast<std::ptrdiff_t>(n_components * node),
                of_whole.begin() + static_cast<std::ptrdiff_t>(n_components * (node + 1)));
  return list;
}

Sheets sheets_of(const SurfaceDiscretization &whole)
{
  Sheets sheets;
  SurfaceDiscretization &surface = sheets.surface;
  surface.kind                   = whole.kind;
  surface.degree                 = whole.degree;
  surface.n_cells                = whole.n_cells;
  surface.tables                 = whole.tables;
  surface.mirror                 = whole.mirror;
  surface.cell_region            = whole.cell_region;
  surface.region_names           = whole.region_names;
  std::map<std::pair<unsigned int, std::size_t>, std::size_t> numbers;
  for (std::size_t i = 0; i < whole.cell_nodes.size(); ++i)
  {
    const unsigned int region = whole.cell_region.empty() ? 0 : whole.cell_region[i / whole.n_local()];
    const auto [at, is_new]   = numbers.try_emplace({region, whole.cell_nodes[i]}, sheets.original.size());
    if (is_new)
      sheets.original.push_back(whole.cell_nodes[i]);
    surface.cell_nodes.push_back(at->second);
  }
  for (const HangingNode &hanging : whole.hanging)
    for (unsigned int region = 0; region < std::max<std::size_t>(1, whole.region_names.size()); ++region)
      if (const auto found = numbers.find({region, hanging.node}); found != numbers.end())
      {
        surface.hanging.push_back({found->second, {}});
        for (const auto &[node, share] : hanging.shares)
          surface.hanging.back().shares.emplace_back(numbers.at({region, node}), share);
      }
  surface.n_nodes        = sheets.original.size();
  surface.positions      = sheets.values(whole.positions, 3);
  surface.mesh_reference = sheets.values(whole.mesh_reference, 3);
  for (const std::size_t node : sheets.original)
    surface.admissible.push_back(whole.admissible.empty() ? AdmissibleDirections{} : whole.admissible[node]);
  return sheets;
}
} // namespace pellicle
