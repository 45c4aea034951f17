// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/refined_quads.h>

#include <map>
#include <utility>

namespace pellicle
{
namespace
{
using DirectedEdge = std::pair<unsigned int, unsigned int>; // from, to

DirectedEdge reversed(const DirectedEdge &edge)
{
  return {edge.second, edge.first};
}

/** Tail and head of every edge, one band of opposite edges after the other. */
class Directions
{
public:
  explicit Directions(const std::vector<QuadVertices> &quads)
  {
    for (const QuadVertices &q : quads)
      for (const auto &[edge, opposite] : {std::pair<DirectedEdge, DirectedEdge>{{q[0], q[1]}, {q[2], q[3]}},
                                           std::pair<DirectedEdge, DirectedEdge>{{q[0], q[2]}, {q[1], q[3]}}})
      {
        add_parallel(edge, opposite);
        add_parallel(opposite, edge);
      }
    for (const auto &entry : parallels)
      if (!is_known(entry.first))
        run_through_band(entry.first);
  }

  bool runs(const unsigned int from, const unsigned int to) const { return chosen.at({from, to}); }

private:
  void add_parallel(const DirectedEdge &edge, const DirectedEdge &other)
  {
    parallels[edge].push_back(other);
    parallels[reversed(edge)].push_back(reversed(other));
  }

  bool is_known(const DirectedEdge &edge) const { return chosen.count(edge) > 0; }

  void run_through_band(const DirectedEdge &first)
  {
    std::vector<DirectedEdge> pending = {first};
    while (!pending.empty())
    {
      const DirectedEdge edge = pending.back();
      pending.pop_back();
      if (is_known(edge))
      {
        PELLICLE_ASSERT(chosen.at(edge), "a twisted band of cells: the surface is not orientable");
        continue;
      }
      chosen[edge]           = true;
      chosen[reversed(edge)] = false;
      for (const DirectedEdge &other : parallels.at(edge))
        pending.push_back(other);
    }
  }

  std::map<DirectedEdge, std::vector<DirectedEdge>> parallels;
  std::map<DirectedEdge, bool> chosen;
};
} // namespace

std::vector<QuadVertices> with_consistent_edges(const std::vector<QuadVertices> &quads)
{
  const Directions directions(quads);
  std::vector<QuadVertices> turned;
  for (const QuadVertices &q : quads)
  {
    // The origin becomes the vertex from which both directions leave; the walk round the cell stays as it is.
    const bool first = directions.runs(q[0], q[1]), second = directions.runs(q[0], q[2]);
    if (first && second)
      turned.push_back(q);
    else if (second)
      turned.push_back({{q[1], q[3], q[0], q[2]}});
    else if (first)
      turned.push_back({{q[2], q[0], q[3], q[1]}});
    else
      turned.push_back({{q[3], q[2], q[1], q[0]}});
  }
  return turned;
}
} // namespace pellicle
