// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/cell_loops.h>
#include <pellicle/base/exceptions.h>

#include <algorithm>

namespace pellicle
{
namespace
{
std::string name_of_set(const SurfaceDiscretization &discretization, const std::size_t set)
{
  const std::size_t n_edges = discretization.edges.size();
  return set == 0         ? "surface"
         : set <= n_edges ? "edge " + discretization.edges[set - 1].name
                          : "body " + discretization.bulks[set - 1 - n_edges].name;
}

LoopTerm term(const LoopTerm::Kind kind, const Potential &potential)
{
  LoopTerm result{kind, potential.name(), {}, {}};
  if (potential.where().part == Where::Part::region)
    result.region = potential.where().name;
  for (const FieldUse &use : potential.fields())
    result.fields.emplace_back(use.name);
  return result;
}
} // namespace

std::vector<CellLoop> cell_loops(const SurfaceDiscretization &discretization, const PotentialSet &set)
{
  std::vector<CellLoop> loops(n_sets(discretization));
  for (std::size_t s = 0; s < loops.size(); ++s)
  {
    loops[s].over     = name_of_set(discretization, s);
    loops[s].n_cells  = n_cells_of(discretization, s);
    loops[s].n_points = loops[s].n_cells * tables_of(discretization, s).n_points;
  }
  const auto place = [&](const LoopTerm::Kind kind, const Potential &potential)
  { loops[set_of(discretization, potential.where())].terms.push_back(term(kind, potential)); };
  for (const auto &energy : set.energies)
    place(LoopTerm::Kind::energy, *energy);
  for (const Dissipation &dissipation : set.dissipations)
    place(LoopTerm::Kind::dissipation, *dissipation.over_step);
  for (const Constraint &constraint : set.constraints)
    for (std::size_t p = 0; p < constraint.n_parts(); ++p)
      place(LoopTerm::Kind::constraint, constraint.part(p));
  loops.erase(std::remove_if(loops.begin(), loops.end(), [](const CellLoop &loop) { return loop.terms.empty(); }),
              loops.end());
  return loops;
}

std::size_t potential_calls(const std::vector<CellLoop> &loops, const SurfaceDiscretization &discretization)
{
  const auto cells_of_region = [&](const std::string &region)
  {
    const auto &names = discretization.region_names;
    const auto number = std::find(names.begin(), names.end(), region) - names.begin();
    return static_cast<std::size_t>(
        std::count(discretization.cell_region.begin(), discretization.cell_region.end(), number));
  };
  std::size_t calls = 0;
  for (const CellLoop &loop : loops)
    for (const LoopTerm &term : loop.terms)
      calls += term.region.empty() ? loop.n_cells : cells_of_region(term.region);
  return calls;
}

const char *kind_name(const LoopTerm::Kind kind)
{
  switch (kind)
  {
  case LoopTerm::Kind::energy:
    return "energy";
  case LoopTerm::Kind::constraint:
    return "constraint";
  case LoopTerm::Kind::dissipation:
    return "dissipation";
  }
  PELLICLE_ASSERT(false, "a kind of terms without a name");
  return "energy";
}
} // namespace pellicle
