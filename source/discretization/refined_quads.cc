// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/hanging_nodes.h>
#include <pellicle/discretization/refined_quads.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <cmath>

namespace pellicle
{
namespace
{
constexpr double most_cells = 1e6;

/** Centre and half width, in the local coordinates of its patch, of a cell that descends from it. */
struct Box
{
  double xi = 0., eta = 0., half = 1.;
};

Box locate(const dealii::CellId &id)
{
  Box box;
  for (const auto child : id.get_child_indices())
  {
    box.half /= 2.; // powers of two: every number here is exact
    box.xi += (child % 2 == 0) ? -box.half : box.half;
    box.eta += (child / 2 == 0) ? -box.half : box.half;
  }
  return box;
}

CellPlace place_of(const unsigned int patch, const Box &box)
{
  return {patch, 0.5 * (1. + box.xi - box.half), 0.5 * (1. + box.eta - box.half), box.half};
}

using Triangulation = dealii::Triangulation<2, 3>;

/** Whether a neighbour in another region is smaller. */
bool meets_smaller_cell_at_line(const Triangulation::active_cell_iterator &cell,
                                const std::vector<unsigned int> &regions)
{
  if (regions.empty())
    return false;
  for (const unsigned int face : cell->face_indices())
    if (!cell->at_boundary(face) && cell->neighbor(face)->has_children() &&
        regions[cell->neighbor(face)->id().get_coarse_cell_id()] != regions[cell->id().get_coarse_cell_id()])
      return true;
  return false;
}

void cut_further(Triangulation &triangulation, const Refinement &refinement, const std::vector<unsigned int> &regions)
{
  for (bool any = !refinement.cut.empty(); any;)
  {
    any = false;
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      const dealii::CellId id = cell->id();
      const CellPlace place   = place_of(static_cast<unsigned int>(id.get_coarse_cell_id()), locate(id));
      if (!refinement.cuts(place) && !meets_smaller_cell_at_line(cell, regions))
        continue;
      cell->set_refine_flag();
      any = true;
    }
    if (any)
      triangulation.execute_coarsening_and_refinement();
  }
}

std::vector<HangingNode> find_hanging_nodes(const dealii::DoFHandler<2, 3> &dofs)
{
  dealii::AffineConstraints<double> constraints;
  dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
  constraints.close();
  std::vector<HangingNode> hanging;
  for (const auto &line : constraints.get_lines())
  {
    hanging.push_back({line.index, {}});
    for (const auto &[node, share] : line.entries)
      hanging.back().shares.emplace_back(node, share);
  }
  return hanging;
}
} // namespace

std::vector<double> line_nodes(const unsigned int degree)
{
  const dealii::FE_Q<1> fe(degree);
  const std::vector<unsigned int> dof_of = fe.get_poly_space_numbering_inverse();
  std::vector<double> nodes(degree + 1);
  for (unsigned int i = 0; i <= degree; ++i)
    nodes[i] = fe.unit_support_point(dof_of[i])[0] - fe.unit_support_point(dof_of[degree - i])[0];
  return nodes;
}

RefinedQuads refine_quads(const std::vector<Vector3<double>> &vertices, const std::vector<QuadVertices> &quads,
                          const Refinement &refinement, const unsigned int degree,
                          const std::vector<unsigned int> &regions)
{
  std::vector<dealii::Point<3>> points;
  for (const Vector3<double> &v : vertices)
    points.emplace_back(v[0], v[1], v[2]);

  const double n_cells = std::ldexp(double(quads.size()), 2 * static_cast<int>(refinement.uniform));
  if (n_cells > most_cells)
    throw UserError("Refinements = " + std::to_string(refinement.uniform) + " would make " + exact_text(n_cells) +
                    " cells of the " + std::to_string(quads.size()) + " that the mesh begins with; at most " +
                    exact_text(most_cells) + " are possible. Refine less, and take a higher degree instead.");

  RefinedQuads mesh;
  mesh.patches = with_consistent_edges(quads);
  std::vector<dealii::CellData<2>> coarse(quads.size());
  for (std::size_t p = 0; p < quads.size(); ++p)
    coarse[p].vertices.assign(mesh.patches[p].begin(), mesh.patches[p].end());

  Triangulation triangulation(Triangulation::limit_level_difference_at_vertices);
  triangulation.create_triangulation(points, coarse, dealii::SubCellData());
  triangulation.refine_global(refinement.uniform);
  cut_further(triangulation, refinement, regions);

  const dealii::FE_Q<2, 3> fe(degree);
  dealii::DoFHandler<2, 3> dofs(triangulation);
  dofs.distribute_dofs(fe);

  mesh.n_nodes = dofs.n_dofs();
  mesh.n_cells = triangulation.n_active_cells();
  mesh.hanging = find_hanging_nodes(dofs);

  const std::vector<double> nodes        = line_nodes(degree);
  const std::vector<unsigned int> dof_of = fe.get_poly_space_numbering_inverse();
  std::vector<dealii::types::global_dof_index> numbers(fe.n_dofs_per_cell());
  for (const auto &cell : dofs.active_cell_iterators())
  {
    PELLICLE_ASSERT(cell->direction_flag(), "patches are not oriented alike");
    cell->get_dof_indices(numbers);
    const dealii::CellId id = cell->id();
    const auto patch        = static_cast<unsigned int>(id.get_coarse_cell_id());
    const Box box           = locate(id);
    const CellPlace place   = place_of(patch, box);
    mesh.cell_places.push_back(place);
    for (unsigned int j = 0; j <= degree; ++j)
      for (unsigned int i = 0; i <= degree; ++i)
      {
        mesh.cell_nodes.push_back(numbers[dof_of[j * (degree + 1) + i]]);
        mesh.cell_sites.push_back({patch, box.xi + box.half * nodes[i], box.eta + box.half * nodes[j], place});
      }
  }
  return mesh;
}

SurfaceDiscretization place_nodes(const RefinedQuads &mesh, const unsigned int degree,
                                  const std::function<Vector3<double>(const PatchPoint &)> &point)
{
  SurfaceDiscretization result;
  result.kind        = SurfaceDiscretization::Kind::surface;
  result.degree      = degree;
  result.n_nodes     = mesh.n_nodes;
  result.n_cells     = mesh.n_cells;
  result.cell_nodes  = mesh.cell_nodes;
  result.cell_places = mesh.cell_places;
  result.hanging     = mesh.hanging;
  result.tables      = make_surface_tables(degree, degree + 1);
  result.rigid_motions.resize(6); // three translations, three rotations
  for (unsigned int c = 0; c < 3; ++c)
  {
    result.rigid_motions[c].translation[c]  = 1.;
    result.rigid_motions[3 + c].rotation[c] = 1.;
  }

  result.positions.resize(3 * mesh.n_nodes);
  std::vector<bool> placed(mesh.n_nodes, false);
  for (std::size_t i = 0; i < mesh.cell_nodes.size(); ++i)
  {
    const std::size_t node = mesh.cell_nodes[i];
    if (placed[node])
      continue;
    placed[node]            = true;
    const Vector3<double> x = point(mesh.cell_sites[i]);
    for (unsigned int c = 0; c < 3; ++c)
      result.positions[3 * node + c] = x[c];
  }
  join_hanging_nodes(result.hanging, result.positions);
  return result;
}

SurfaceDiscretization place_nodes(const RefinedQuads &mesh, const std::vector<QuadVertices> &quads,
                                  const unsigned int degree,
                                  const std::function<Vector3<double>(unsigned int patch, double u, double v)> &point)
{
  return place_nodes(mesh, degree,
                     [&](const PatchPoint &site)
                     {
                       // A patch is turned by as many quarters as its origin has moved round the quadrilateral.
                       const QuadVertices &given = quads[site.patch];
                       const auto origin =
                           std::find(given.begin(), given.end(), mesh.patches[site.patch][0]) - given.begin();
                       const double u = 0.5 * (1. + site.xi), v = 0.5 * (1. + site.eta);
                       const double back_u = 0.5 * (1. - site.xi), back_v = 0.5 * (1. - site.eta);
                       switch (origin)
                       {
                       case 0:
                         return point(site.patch, u, v);
                       case 1:
                         return point(site.patch, back_v, u);
                       case 2:
                         return point(site.patch, v, back_u);
                       default:
                         return point(site.patch, back_u, back_v);
                       }
                     });
}

std::vector<Vector3<double>>
corner_points(const std::vector<QuadVertices> &quads, const std::size_t n_vertices,
              const std::function<Vector3<double>(unsigned int patch, double u, double v)> &point)
{
  std::vector<Vector3<double>> vertices(n_vertices);
  for (unsigned int p = 0; p < quads.size(); ++p)
    for (unsigned int corner = 0; corner < 4; ++corner)
      vertices[quads[p][corner]] = point(p, corner % 2, corner / 2);
  return vertices;
}
} // namespace pellicle
