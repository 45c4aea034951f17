// SPDX-License-Identifier: LGPL-2.1-or-later
#include "body_degree.h"
#include "graded_line.h"

#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/bodies.h>
#include <pellicle/discretization/edge_loops.h>
#include <pellicle/discretization/refined_quads.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace pellicle
{
namespace
{
constexpr unsigned int highest_hexahedral_degree = 3; ///< 64 nodes a cell
constexpr unsigned int highest_degree            = 5;

/** Nodes along one direction. */
struct Line
{
  std::vector<double> nodes;
  std::size_t n_cells = 0;

  Line(const std::string &coordinate, const std::vector<double> &ends, const unsigned int degree)
      : n_cells(ends.empty() ? 0 : ends.size() - 1)
  {
    if (n_cells == 0 || !std::is_sorted(ends.begin(), ends.end(), std::less_equal<double>()))
      throw UserError("A body needs at least two ends of cells along " + coordinate +
                      ", each greater than the one before it.");
    const std::vector<double> unit = line_nodes(degree);
    for (std::size_t c = 0; c < n_cells; ++c)
      for (unsigned int i = 0; i < degree; ++i)
        nodes.push_back(ends[c] + 0.5 * (1. + unit[i]) * (ends[c + 1] - ends[c]));
    nodes.push_back(ends.back());
  }
};

/** Numbers of the nodes of a grid of n[0] x n[1] x n[2], the first coordinate fastest. */
struct Grid
{
  std::array<std::size_t, 3> n;

  std::size_t operator()(const std::size_t i, const std::size_t j, const std::size_t k) const
  {
    return i + n[0] * (j + n[1] * k);
  }
  /** All nodes at which coordinate `direction` has the given value. */
  std::vector<std::size_t> face(const unsigned int direction, const std::size_t value) const
  {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < n[2]; ++k)
      for (std::size_t j = 0; j < n[1]; ++j)
        for (std::size_t i = 0; i < n[0]; ++i)
          if (std::array<std::size_t, 3>{{i, j, k}}[direction] == value)
            result.push_back((*this)(i, j, k));
    return result;
  }
};
} // namespace

std::vector<double> cell_ends(const double from, const double to, const unsigned int n_cells, const double first,
                              const double last)
{
  const double equal = (to - from) / n_cells;
  for (const double size : {first, last})
    if (!(size >= 0. && size <= equal * (1. + 1e-12)))
      throw UserError("Size of a cell = " + exact_text(size) + ": it must lie between 0 (no grading) and " +
                      exact_text(equal) + ", the size of " + std::to_string(n_cells) + " equal cells.");
  const GradedLine line(to - from, n_cells, first, last);
  std::vector<double> ends;
  for (unsigned int c = 0; c < n_cells; ++c)
    ends.push_back(from + line.at(c));
  ends.push_back(to);
  return ends;
}

SurfaceDiscretization block(const std::string &name, const BlockShape &shape, const unsigned int degree)
{
  check_body_degree(degree, highest_hexahedral_degree);
  const Line x("x", shape.x, degree), y("y", shape.y, degree), z("z", shape.z, degree);
  const Grid grid{{{x.nodes.size(), y.nodes.size(), z.nodes.size()}}};

  SurfaceDiscretization result;
  result.degree  = degree;
  result.n_nodes = x.nodes.size() * y.nodes.size() * z.nodes.size();
  for (const double node_z : z.nodes)
    for (const double node_y : y.nodes)
      for (const double node_x : x.nodes)
        result.positions.insert(result.positions.end(), {node_x, node_y, node_z});
  result.mesh_reference = result.positions;

  BulkPart body;
  body.name    = name;
  body.n_cells = x.n_cells * y.n_cells * z.n_cells;
  body.tables  = make_hexahedron_tables(degree, degree + 1);
  for (std::size_t cz = 0; cz < z.n_cells; ++cz)
    for (std::size_t cy = 0; cy < y.n_cells; ++cy)
      for (std::size_t cx = 0; cx < x.n_cells; ++cx)
        for (unsigned int k = 0; k <= degree; ++k)
          for (unsigned int j = 0; j <= degree; ++j)
            for (unsigned int i = 0; i <= degree; ++i)
              body.cell_nodes.push_back(grid(cx * degree + i, cy * degree + j, cz * degree + k));
  const std::pair<const char *, const char *> names[3] = {{"left", "right"}, {"front", "back"}, {"bottom", "top"}};
  for (unsigned int d = 0; d < 3; ++d)
  {
    body.faces[names[d].first]  = grid.face(d, 0);
    body.faces[names[d].second] = grid.face(d, grid.n[d] - 1);
  }

  result.tables  = make_surface_tables(degree, degree + 1);
  result.n_cells = x.n_cells * y.n_cells;
  for (std::size_t cy = 0; cy < y.n_cells; ++cy)
    for (std::size_t cx = 0; cx < x.n_cells; ++cx)
      for (unsigned int j = 0; j <= degree; ++j)
        for (unsigned int i = 0; i <= degree; ++i)
          result.cell_nodes.push_back(grid(cx * degree + i, cy * degree + j, grid.n[2] - 1));
  result.edges = find_rims(result, [](const Vector3<double> &) { return std::string("rim"); });
  result.bulks.push_back(std::move(body));
  return result;
}

SurfaceDiscretization cylinder(const std::string &name, const CylinderShape &shape, const unsigned int degree)
{
  check_body_degree(degree, highest_degree);
  const Line r("r", shape.r, degree), z("z", shape.z, degree);
  if (r.nodes.front() < 0.)
    throw UserError("A cylinder about z begins at r >= 0, not at r = " + exact_text(r.nodes.front()) + ".");
  const bool hollow = r.nodes.front() > 0.;
  const Grid grid{{{z.nodes.size(), r.nodes.size(), 1}}};

  SurfaceDiscretization result;
  result.kind    = SurfaceDiscretization::Kind::meridian;
  result.degree  = degree;
  result.n_nodes = r.nodes.size() * z.nodes.size();
  AdmissibleDirections in_plane, along_axis;
  in_plane.count     = 2;
  in_plane.columns   = {{{{1., 0., 0.}}, {{0., 0., 1.}}, {{0., 0., 0.}}}};
  along_axis.count   = 1;
  along_axis.columns = {{{{0., 0., 1.}}, {{0., 0., 0.}}, {{0., 0., 0.}}}};
  for (const double node_r : r.nodes)
    for (const double node_z : z.nodes)
    {
      result.positions.insert(result.positions.end(), {node_r, 0., node_z});
      result.admissible.push_back(node_r > 0. ? in_plane : along_axis);
    }
  result.mesh_reference = result.positions;

  BulkPart body;
  body.name    = name;
  body.n_cells = r.n_cells * z.n_cells;
  body.tables  = make_revolved_quad_tables(degree, degree + 1);
  for (std::size_t cr = 0; cr < r.n_cells; ++cr)
    for (std::size_t cz = 0; cz < z.n_cells; ++cz)
      for (unsigned int j = 0; j <= degree; ++j)
        for (unsigned int i = 0; i <= degree; ++i)
          body.cell_nodes.push_back(grid(cz * degree + i, cr * degree + j, 0));
  body.faces["bottom"] = grid.face(0, 0);
  body.faces["top"]    = grid.face(0, grid.n[0] - 1);
  body.faces["side"]   = grid.face(1, grid.n[1] - 1);
  if (hollow)
    body.faces["inner side"] = grid.face(1, 0);

  result.tables  = make_meridian_tables(degree, degree + 1, false);
  result.n_cells = r.n_cells;
  for (std::size_t cr = 0; cr < r.n_cells; ++cr)
    for (unsigned int j = 0; j <= degree; ++j)
      result.cell_nodes.push_back(grid(grid.n[0] - 1, cr * degree + j, 0));
  result.edges.push_back(circle_loop(result, "rim", r.n_cells - 1, true, true));
  if (hollow)
    result.edges.push_back(circle_loop(result, "inner rim", 0, false, true));
  result.bulks.push_back(std::move(body));
  return result;
}

void keep_on_plane(SurfaceDiscretization &discretization, const std::vector<std::size_t> &nodes,
                   const Vector3<double> &normal)
{
  for (const std::size_t node : nodes)
    keep_on_plane(discretization, node, normal);
}

// Columns that are orthogonal to the normal stay as they are; of the others their parts along the plane do.
void keep_on_plane(SurfaceDiscretization &discretization, const std::size_t node, const Vector3<double> &normal)
{
  constexpr double smallest = 1e-12;
  discretization.admissible.resize(discretization.n_nodes);
  AdmissibleDirections &directions = discretization.admissible[node];
  AdmissibleDirections kept;
  kept.count   = 0;
  kept.columns = {};
  std::vector<Vector3<double>> others;
  const auto append = [&](const Vector3<double> &e) { kept.columns[kept.count++] = {{e[0], e[1], e[2]}}; };
  for (unsigned int j = 0; j < directions.count; ++j)
  {
    const auto &column = directions.columns[j];
    const Vector3<double> e(column[0], column[1], column[2]);
    if (std::abs(dot(e, normal)) < smallest)
      append(e);
    else
      others.push_back(e);
  }
  for (Vector3<double> e : others)
  {
    e -= dot(e, normal) * normal;
    for (unsigned int j = 0; j < kept.count; ++j)
    {
      const auto &column = kept.columns[j];
      const Vector3<double> before(column[0], column[1], column[2]);
      e -= dot(e, before) * before;
    }
    if (norm(e) > smallest)
      append((1. / norm(e)) * e);
  }
  directions = kept;
}
} // namespace pellicle
