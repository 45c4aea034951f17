// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/contact_search.h>
#include <pellicle/base/exceptions.h>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace pellicle
{
namespace
{
namespace bg = boost::geometry;

using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Box   = bg::model::box<Point>;
using Entry = std::pair<Box, std::size_t>;
using Tree  = bg::index::rtree<Entry, bg::index::rstar<16>>;

Point as_point(const Vector3<double> &x)
{
  return Point(x[0], x[1], x[2]);
}

/** Contains all points of the cell: |x - centre| <= sum_K |M_K| |x_K - centre| in each component. */
Box bounding_box(const CellShape &cell)
{
  const double reach   = cell.line.lebesgue_constant() * cell.line.lebesgue_constant();
  Vector3<double> low  = cell.nodes[0];
  Vector3<double> high = cell.nodes[0];
  for (std::size_t i = 1; i < cell.n_nodes(); ++i)
    for (unsigned int c = 0; c < 3; ++c)
    {
      low[c]  = std::min(low[c], cell.nodes[i][c]);
      high[c] = std::max(high[c], cell.nodes[i][c]);
    }
  const Vector3<double> centre = 0.5 * (low + high), half = (0.5 * reach) * (high - low);
  return Box(as_point(centre - half), as_point(centre + half));
}

/** n_p and g of a projection: the normal of the cell, or on edges and at vertices r/|r| on its outer side. */
void set_gap(const Vector3<double> &x, ContactPartner &partner)
{
  const Vector3<double> r = x - partner.at.foot, &outward = partner.at.outward;
  if (partner.at.n_free() == 2)
  {
    partner.normal = outward / norm(outward);
    partner.gap    = dot(r, partner.normal);
    return;
  }
  partner.gap    = dot(r, outward) < 0. ? -partner.at.distance : partner.at.distance;
  partner.normal = r / partner.gap;
}

/** Nearer, or as near and inside a cell instead of on its side. Cells that meet in the closest point find it with small
 * differences. */
bool is_better(const ContactPartner &a, const ContactPartner &b)
{
  constexpr double equally_near = 1e-10;
  const double margin           = equally_near * b.at.distance + 1e-14 * norm(b.at.foot);
  return a.at.distance < b.at.distance - margin ||
         (a.at.distance <= b.at.distance + margin && a.at.n_free() > b.at.n_free());
}

std::string text(const Vector3<double> &x)
{
  return "(" + std::to_string(x[0]) + ", " + std::to_string(x[1]) + ", " + std::to_string(x[2]) + ")";
}
} // namespace

struct ContactSearch::Boxes
{
  Tree tree;
};

/** What cells offer a point. */
struct ContactSearch::Candidates
{
  std::vector<ContactPartner> offered;
  double nearest_refused = std::numeric_limits<double>::max(); ///< distance, on a rim or facing away

  /** Whether something that was refused is nearer. */
  bool is_behind(const ContactPartner &partner) const { return nearest_refused < partner.at.distance; }

  /** The nearest one. A cell's side is left out if it only seems closest because its neighbour was refused. */
  const ContactPartner *best() const
  {
    const ContactPartner *best = nullptr;
    for (const ContactPartner &partner : offered)
      if ((partner.at.n_free() == 2 || !is_behind(partner)) && (!best || is_better(partner, *best)))
        best = &partner;
    return best;
  }
};

ContactSearch::ContactSearch(SurfaceCells master, const SearchLimits &limits)
    : cells(std::move(master))
    , limits(limits)
    , line(cells.degree)
    , nodes(cells.cell_nodes.size())
    , boxes(std::make_unique<Boxes>())
{
  if (!(limits.distance > 0. && limits.penetration > 0.))
    throw UserError("The search for contact reaches " + std::to_string(limits.distance) + " outward and " +
                    std::to_string(limits.penetration) +
                    " inward; both must be > 0, say half the smallest radius of curvature.");
}

ContactSearch::~ContactSearch()                         = default;
ContactSearch::ContactSearch(ContactSearch &&) noexcept = default;

void ContactSearch::update(const NodalVectors &positions)
{
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const double *const x = positions.data() + 3 * cells.cell_nodes[i];
    nodes[i]              = {x[0], x[1], x[2]};
  }
  std::vector<Entry> entries;
  for (std::size_t c = 0; c < cells.size(); ++c)
    entries.emplace_back(bounding_box(shape(c)), c);
  boxes->tree = Tree(entries);
}

std::optional<ContactPartner> ContactSearch::closest(const Vector3<double> &x, const Vector3<double> &slave_normal,
                                                     const std::optional<std::size_t> previous) const
{
  // A point that faces away from all that is near it would otherwise see the whole master.
  constexpr unsigned int most_cells = 16;
  Candidates candidates;
  if (previous)
    try_cell(*previous, x, slave_normal, candidates);

  unsigned int n_tried = 0;
  const Tree &tree     = boxes->tree;
  for (auto entry = tree.qbegin(bg::index::nearest(as_point(x), cells.size())); entry != tree.qend(); ++entry)
  {
    const double distance            = bg::distance(as_point(x), entry->first);
    const ContactPartner *const best = candidates.best();
    const bool too_far               = n_tried > 0 && distance > limits.distance && !(best && best->gap < 0.);
    if (n_tried == most_cells || too_far || (best && distance > best->at.distance))
      break;
    ++n_tried;
    if (entry->second != previous)
      try_cell(entry->second, x, slave_normal, candidates);
  }
  const ContactPartner *const best = candidates.best();
  if (!best || best->gap > limits.distance)
    return {};
  if (-best->gap <= limits.penetration)
    return *best;
  if (candidates.is_behind(*best))
    return {};
  throw SolveError("The point " + text(x) + " is " + std::to_string(-best->gap) + " inside cell " +
                   std::to_string(best->cell) + " of the surface that it touches; at most " +
                   std::to_string(limits.penetration) +
                   " is followed. Begin with the bodies apart or just touching, or take smaller steps.");
}

/** Whether what holds the point, a side or a vertex, belongs to a rim of the master. */
bool ContactSearch::on_rim(const std::size_t cell, const CellProjection &at) const
{
  const bool high_0 = at.xi[0] > 0.5, high_1 = at.xi[1] > 0.5;
  if (at.n_free() == 0)
    return cells.rim_vertex[cell][(high_0 ? 1 : 0) + (high_1 ? 2 : 0)];
  if (!at.free[0])
    return cells.rim_side[cell][high_0 ? 1 : 3];
  return !at.free[1] && cells.rim_side[cell][high_1 ? 2 : 0];
}

void ContactSearch::try_cell(const std::size_t cell, const Vector3<double> &x, const Vector3<double> &slave_normal,
                             Candidates &candidates) const
{
  ContactPartner partner;
  partner.cell = cell;
  partner.at   = project_on_cell(x, shape(cell));
  bool refused = on_rim(cell, partner.at);
  if (!refused)
  {
    set_gap(x, partner);
    refused = norm(slave_normal) > 0. && dot(slave_normal, partner.normal) >= 0.;
  }
  if (refused)
    candidates.nearest_refused = std::min(candidates.nearest_refused, partner.at.distance);
  else
    candidates.offered.push_back(partner);
}
} // namespace pellicle
