// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/bordered_system.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/hanging_nodes.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pellicle
{
Numbering::Numbering(std::vector<NodalChart> all_charts, const std::size_t n_constraints, const std::size_t n_rigid)
    : charts(std::move(all_charts))
    , n_constraints(n_constraints)
    , n_rigid(n_rigid)
{
  std::size_t n_nodes = 0;
  for (const NodalChart &chart : charts)
    n_nodes = std::max(n_nodes, chart.nodes.size());
  first.resize(n_nodes * charts.size());
  for (std::size_t I = 0; I < n_nodes; ++I)
    for (std::size_t f = 0; f < charts.size(); ++f)
      if (charts[f].leads(I))
      {
        first[I * charts.size() + f] = n_nodal;
        n_nodal += count(f, I);
      }
  for (std::size_t I = 0; I < n_nodes; ++I)
    for (std::size_t f = 0; f < charts.size(); ++f)
      if (!charts[f].leads(I))
        first[I * charts.size() + f] = first[charts[f].leader[I] * charts.size() + f];
}

std::size_t Numbering::n_unknowns_of(const std::size_t field) const
{
  std::size_t n = 0;
  for (std::size_t I = 0; I < charts[field].nodes.size(); ++I)
    if (charts[field].leads(I))
      n += charts[field].nodes[I].count;
  return n;
}

BorderedSystem::BorderedSystem(const SurfaceDiscretization &discretization, Numbering numbering,
                               const Communicator &communicator)
    : discretization(discretization)
    , communicator(communicator)
    , unknowns(std::move(numbering))
{
  make_pattern();
  constraint_rows.resize(unknowns.n_constraints);
}

// Of the first fields.
void BorderedSystem::cell_unknowns(const Cell &cell, const std::size_t n_fields)
{
  cell_list.clear();
  cell_columns.clear();
  first_cell_column.clear();
  place_in_list.resize(unknowns.n_nodal, -1);
  for (std::size_t i = 0; i < cell.n_nodes; ++i)
    for (std::size_t f = 0; f < n_fields; ++f)
    {
      first_cell_column.push_back(cell_columns.size());
      unknowns.for_all_columns(f, cell.nodes[i],
                               [&](const std::size_t unknown, const Vector3<double> &along, const bool mesh_equation)
                               {
                                 int &place = place_in_list[unknown];
                                 if (place < 0)
                                 {
                                   place = static_cast<int>(cell_list.size());
                                   cell_list.push_back(static_cast<int>(unknown));
                                 }
                                 cell_columns.push_back({static_cast<std::size_t>(place), along, mesh_equation});
                               });
    }
  first_cell_column.push_back(cell_columns.size());
  for (const int unknown : cell_list)
    place_in_list[unknown] = -1;
}

// Rows of nodal unknowns couple through cells; border rows (and columns, unless the matrix is symmetric) are dense.
void BorderedSystem::make_pattern()
{
  const std::vector<Cell> cells = own_cells(discretization, communicator);
  const bool mesh_equations     = std::any_of(unknowns.charts.begin(), unknowns.charts.end(),
                                              [](const NodalChart &c) { return c.has_mesh_equations(); });
  sparse.symmetry               = mesh_equations ? MatrixSymmetry::general : MatrixSymmetry::symmetric;
  const bool lower              = sparse.symmetry == MatrixSymmetry::symmetric;
  const int n_nodal = static_cast<int>(unknowns.n_nodal), n = static_cast<int>(unknowns.size());
  sparse.size = n;

  // Unknowns of every cell and coupling, and which of these an unknown belongs to.
  std::vector<std::vector<int>> groups;
  std::vector<std::vector<std::size_t>> groups_of(n_nodal);
  const auto add_group = [&]
  {
    for (const int i : cell_list)
      groups_of[i].push_back(groups.size());
    groups.push_back(cell_list);
  };
  for (const Cell &cell : cells)
  {
    cell_unknowns(cell, unknowns.n_fields());
    add_group();
  }
  for (const std::vector<std::size_t> &nodes : couplings)
  {
    cell_unknowns({0, 0, 0, nodes.data(), nodes.size()}, 1);
    add_group();
  }
  sparse.columns.clear();
  scatter_start.clear();
  scatter.clear();
  sparse.row_start.assign(1, 0);
  diagonal.assign(n, -1);
  std::vector<int> row, last_row(n_nodal, -1); // in which a column was met last
  const auto add_column = [&](const int i, const int j)
  {
    if (last_row[j] == i || (lower && j > i))
      return;
    last_row[j] = i;
    row.push_back(j);
  };
  for (int i = 0; i < n; ++i)
  {
    if (i < n_nodal)
    {
      row.clear();
      add_column(i, i);
      for (const std::size_t group : groups_of[i])
        for (const int j : groups[group])
          add_column(i, j);
      std::sort(row.begin(), row.end());
      if (!lower)
        for (int j = n_nodal; j < n; ++j)
          row.push_back(j);
      sparse.columns.insert(sparse.columns.end(), row.begin(), row.end());
    }
    else
    {
      for (int j = 0; j < n_nodal; ++j)
        sparse.columns.push_back(j);
      sparse.columns.push_back(i);
    }
    sparse.row_start.push_back(static_cast<int>(sparse.columns.size()));
    const auto begin = sparse.columns.begin() + sparse.row_start[i], end = sparse.columns.end();
    diagonal[i] = static_cast<int>(std::lower_bound(begin, end, i) - sparse.columns.begin());
  }
  sparse.values.assign(sparse.columns.size(), 0.);

  std::vector<int> place(n_nodal); // of a row's columns
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    scatter_start.push_back(scatter.size());
    for (const int i : groups[c])
    {
      for (int k = sparse.row_start[i]; k < sparse.row_start[i + 1] && sparse.columns[k] < n_nodal; ++k)
        place[sparse.columns[k]] = k;
      for (const int j : groups[c])
        scatter.push_back(!lower || j <= i ? place[j] : -1);
    }
  }
}

int BorderedSystem::place_of(const int row, const int column) const
{
  const auto begin = sparse.columns.begin() + sparse.row_start[row],
             end   = sparse.columns.begin() + sparse.row_start[row + 1];
  return static_cast<int>(std::lower_bound(begin, end, column) - sparse.columns.begin());
}

void BorderedSystem::make_room(const std::vector<ContactElement> &elements)
{
  const std::size_t before = couplings.size();
  for (const ContactElement &element : elements)
    couplings.insert(element.nodes);
  if (couplings.size() > before)
    make_pattern();
}

void BorderedSystem::begin()
{
  std::fill(sparse.values.begin(), sparse.values.end(), 0.);
  right.assign(unknowns.size(), 0.);
  contributions.assign(unknowns.n_nodal, 0.);
  for (std::vector<double> &row : constraint_rows)
    row.assign(unknowns.n_nodal, 0.);
  mesh_row.assign(unknowns.n_nodal, false);
  for (std::size_t f = 0; f < unknowns.n_fields(); ++f)
    for (std::size_t I = 0; I < unknowns.charts[f].nodes.size(); ++I)
      for (unsigned int a = 0; a < unknowns.count(f, I); ++a)
        mesh_row[unknowns.first_of(f, I) + a] = unknowns.charts[f].nodes[I].mesh_equation[a];
}

// Z^T K Z for the cell, rows of mesh equations from the mesh energy.
void BorderedSystem::project(const Cell &cell, const Element &physics, const Element *mesh)
{
  const std::size_t n_local = cell.n_nodes, n_fields = physics.n_rows / (3 * n_local);
  const std::size_t m = cell_list.size();
  projected.assign(m * m, 0.);
  row_times_Z.resize(m);
  const auto columns_of = [&](const std::size_t i, const std::size_t f, const auto &visit)
  {
    for (std::size_t k = first_cell_column[i * n_fields + f]; k < first_cell_column[i * n_fields + f + 1]; ++k)
      visit(cell_columns[k]);
  };

  // First the columns: K Z for one row of R^3 at a time, then the rows.
  const auto fill_rows = [&](const Element &element, const bool mesh_rows, const std::size_t n_element_fields)
  {
    for (std::size_t i = 0; i < n_local; ++i)
      for (std::size_t f = 0; f < n_element_fields; ++f)
      {
        bool wanted = false;
        columns_of(i, f, [&](const CellColumn &row) { wanted = wanted || row.mesh_equation == mesh_rows; });
        if (!wanted)
          continue;
        for (unsigned int c = 0; c < 3; ++c)
        {
          const double *K = element.matrix.data() + ((3 * f + c) * n_local + i) * element.n_rows;
          std::fill(row_times_Z.begin(), row_times_Z.end(), 0.);
          for (std::size_t j = 0; j < n_local; ++j)
            for (std::size_t g = 0; g < n_element_fields; ++g)
            {
              const Vector3<double> k(K[3 * g * n_local + j], K[(3 * g + 1) * n_local + j],
                                      K[(3 * g + 2) * n_local + j]);
              columns_of(j, g, [&](const CellColumn &column) { row_times_Z[column.local] += dot(k, column.along); });
            }
          columns_of(i, f,
                     [&](const CellColumn &row)
                     {
                       const double z = row.along[c];
                       if (row.mesh_equation == mesh_rows && z != 0.)
                         for (std::size_t j = 0; j < m; ++j)
                           projected[row.local * m + j] += z * row_times_Z[j];
                     });
        }
      }
  };
  fill_rows(physics, false, n_fields);
  if (mesh != nullptr)
    fill_rows(*mesh, true, 1);
}

// Second derivative of the retraction of unit vectors, v -> (v + d)/|v + d|: -(g . v) |d|^2/2 with d orthogonal to v;
// of nodes on bodies, x -> closest point of x + d: -(g . n) (d . hessian d)/2. What acts on a hanging node acts, by its
// shares, on the nodes that carry it.
void BorderedSystem::curve(const Cell &cell, const Element &physics, const Element *mesh)
{
  const std::size_t m = cell_list.size(), n_fields = physics.n_rows / (3 * cell.n_nodes);
  for (std::size_t i = 0; i < cell.n_nodes; ++i)
    for (std::size_t f = 0; f < n_fields; ++f)
    {
      const NodalChart &chart = unknowns.charts[f];
      if (chart.unit_vectors.empty() && chart.on_body.empty())
        continue;
      const auto component_along = [&](const std::vector<double> &gradient, const Vector3<double> &direction)
      {
        double along = 0.;
        for (unsigned int c = 0; c < 3; ++c)
          along += direction[c] * gradient[(3 * f + c) * cell.n_nodes + i];
        return along;
      };
      const CellColumn *columns_here = cell_columns.data() + first_cell_column[i * n_fields + f];
      const auto add                 = [&](const std::size_t node, const double share)
      {
        const NodalChart::Node &at  = chart.nodes[node];
        const CellColumn *const own = columns_here;
        columns_here += at.count;
        if (at.count > 0 && !chart.unit_vectors.empty())
        {
          const auto &v      = chart.unit_vectors[node];
          const double along = share * component_along(physics.gradient, {v[0], v[1], v[2]});
          for (unsigned int a = 0; a < at.count; ++a)
            projected[own[a].local * m + own[a].local] -= along;
        }
        if (chart.on_body.empty() || !chart.on_body[node])
          return;
        const GapSample &gap = chart.on_body[node]->here;
        const auto column    = [&](const unsigned int a)
        { return Vector3<double>(at.columns[3 * a], at.columns[3 * a + 1], at.columns[3 * a + 2]); };
        for (unsigned int a = 0; a < at.count; ++a)
        {
          if (own[a].mesh_equation && mesh == nullptr)
            continue;
          const double along =
              share * component_along(own[a].mesh_equation ? mesh->gradient : physics.gradient, gap.normal);
          for (unsigned int b = 0; b < at.count; ++b)
            projected[own[a].local * m + own[b].local] -= along * dot(column(a), gap.hessian * column(b));
        }
      };
      const std::size_t I = cell.nodes[i];
      if (chart.nodes[I].count > 0)
        add(I, 1.);
      else if (!chart.carriers.empty())
        for (const NodalChart::Carrier &carrier : chart.carriers[I])
          add(carrier.node, carrier.share[0]);
    }
}

void BorderedSystem::add_cell(const Cell &cell, const Element &physics,
                              const std::vector<std::vector<double>> &constraint_gradients, const Element *mesh)
{
  add_cell_residual(cell, physics, constraint_gradients, mesh);
  cell_unknowns(cell, unknowns.n_fields());
  const std::size_t m = cell_list.size();
  project(cell, physics, mesh);
  curve(cell, physics, mesh);
  const int *positions = scatter.data() + scatter_start[cell.own];
  for (std::size_t k = 0; k < m * m; ++k)
    if (positions[k] >= 0)
      sparse.values[positions[k]] += projected[k];
}

void BorderedSystem::add_cell_residual(const Cell &cell, const Element &physics,
                                       const std::vector<std::vector<double>> &constraint_gradients,
                                       const Element *mesh)
{
  const std::size_t n_fields = physics.n_rows / (3 * cell.n_nodes);
  // A system without border has no rows for them; pairs have no constraints.
  const std::size_t n_constraints = std::min(unknowns.n_constraints, constraint_gradients.size());
  for (std::size_t i = 0; i < cell.n_nodes; ++i)
    for (std::size_t f = 0; f < n_fields; ++f)
    {
      const auto add = [&](const std::size_t unknown, const Vector3<double> &column, const bool mesh_equation)
      {
        const auto along_column = [&](const std::vector<double> &gradient)
        {
          double sum = 0.;
          for (unsigned int c = 0; c < 3; ++c)
            sum += column[c] * gradient[(3 * f + c) * cell.n_nodes + i];
          return sum;
        };
        if (!mesh_equation || mesh != nullptr)
        {
          const double r = along_column(mesh_equation ? mesh->gradient : physics.gradient);
          right[unknown] += r;
          contributions[unknown] += std::abs(r);
        }
        for (std::size_t k = 0; k < n_constraints; ++k)
          if (!constraint_gradients[k].empty())
            constraint_rows[k][unknown] += along_column(constraint_gradients[k]);
      };
      unknowns.for_all_columns(f, cell.nodes[i], add);
    }
}

void BorderedSystem::add_pair(const ContactElement &element)
{
  const Cell cell{0, 0, 0, element.nodes.data(), element.nodes.size()};
  add_cell_residual(cell, element.derivatives, {}, nullptr);
  cell_unknowns(cell, 1);
  project(cell, element.derivatives, nullptr);
  curve(cell, element.derivatives, nullptr);
  const std::size_t m = cell_list.size();
  const bool lower    = sparse.symmetry == MatrixSymmetry::symmetric;
  for (std::size_t a = 0; a < m; ++a)
    for (std::size_t b = 0; b < m; ++b)
      if (!lower || cell_list[b] <= cell_list[a])
        sparse.values[place_of(cell_list[a], cell_list[b])] += projected[a * m + b];
}

void BorderedSystem::set_constraint(const std::size_t k, const double compliance, const double residual)
{
  const std::size_t row = unknowns.n_nodal + k;
  if (communicator.rank() == 0)
  {
    sparse.values[diagonal[row]] = -compliance;
    right[row]                   = residual;
  }
}

void BorderedSystem::set_rigid_motion(const std::size_t k, const NodalVectors &direction, const double inverse_rho,
                                      const double reaction)
{
  if (communicator.rank() != 0)
    return;
  const std::size_t row = unknowns.n_nodal + unknowns.n_constraints + k;
  std::vector<double> restricted(unknowns.n_nodal, 0.);
  restrict_vector(0, direction, restricted);
  for (std::size_t i = 0; i < unknowns.n_nodal; ++i)
  {
    right[i] += reaction * restricted[i];
    sparse.values[sparse.row_start[row] + i] = restricted[i];
    if (sparse.symmetry == MatrixSymmetry::general)
      sparse.values[sparse.row_start[i + 1] - unknowns.size() + row] = restricted[i];
  }
  sparse.values[diagonal[row]] = -inverse_rho;
}

void BorderedSystem::finish()
{
  communicator.sum(right);
  communicator.sum(contributions);
  for (std::size_t k = 0; k < unknowns.n_constraints; ++k)
  {
    communicator.sum(constraint_rows[k]);
    write_border(unknowns.n_nodal + k, constraint_rows[k]);
  }
}

// Border row, and for a general matrix the column beside it, on the first process (the sum counts). Mesh equations know
// no multipliers.
void BorderedSystem::write_border(const std::size_t row, const std::vector<double> &values)
{
  if (communicator.rank() != 0)
    return;
  std::copy(values.begin(), values.end(), sparse.values.begin() + sparse.row_start[row]);
  if (sparse.symmetry == MatrixSymmetry::symmetric)
    return;
  for (std::size_t i = 0; i < unknowns.n_nodal; ++i)
    if (!mesh_row[i])
      sparse.values[sparse.row_start[i + 1] - static_cast<int>(unknowns.size()) + static_cast<int>(row)] = values[i];
}

double BorderedSystem::residual_norm() const
{
  double sum = 0.;
  for (std::size_t i = 0; i < unknowns.n_nodal; ++i)
    sum += right[i] * right[i];
  return std::sqrt(sum);
}

double BorderedSystem::contribution_norm() const
{
  double sum = 0.;
  for (const double c : contributions)
    sum += c * c;
  return std::sqrt(sum);
}

void BorderedSystem::add_to_diagonal(const std::vector<double> &values, const double factor)
{
  if (communicator.rank() == 0)
    for (std::size_t i = 0; i < unknowns.n_nodal; ++i)
      sparse.values[diagonal[i]] += factor * values[i];
}

void BorderedSystem::restrict_vector(const std::size_t field, const NodalVectors &vector,
                                     std::vector<double> &result) const
{
  for (std::size_t I = 0; I < unknowns.charts[field].nodes.size(); ++I)
    unknowns.for_all_columns(field, I,
                             [&](const std::size_t unknown, const Vector3<double> &column, const bool)
                             {
                               for (unsigned int c = 0; c < 3; ++c)
                                 result[unknown] += column[c] * vector[3 * I + c];
                             });
}

void BorderedSystem::add_columns(const std::vector<double> &u, const double factor, const std::size_t field,
                                 NodalVectors &values) const
{
  for (std::size_t I = 0; I < unknowns.charts[field].nodes.size(); ++I)
    unknowns.for_all_columns(field, I,
                             [&](const std::size_t unknown, const Vector3<double> &column, const bool)
                             {
                               for (unsigned int c = 0; c < 3; ++c)
                                 values[3 * I + c] += factor * u[unknown] * column[c];
                             });
}

void BorderedSystem::prolongate(const std::vector<double> &u, const double factor, const std::size_t field,
                                NodalVectors &values) const
{
  add_columns(u, factor, field, values);
  for (std::size_t I = 0; I < unknowns.charts[field].on_body.size(); ++I)
    if (const auto &on = unknowns.charts[field].on_body[I])
    {
      const Vector3<double> foot = on->body->gap({values[3 * I], values[3 * I + 1], values[3 * I + 2]}).foot;
      for (unsigned int c = 0; c < 3; ++c)
        values[3 * I + c] = foot[c];
    }
  for (std::size_t I = 0; I < unknowns.charts[field].unit_vectors.size(); ++I)
    if (unknowns.count(field, I) > 0)
    {
      double *v           = values.data() + 3 * I;
      const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      for (unsigned int c = 0; c < 3; ++c)
        v[c] /= length;
    }
  // Where carriers were put on a body or the unit sphere, and against round-off.
  if (!unknowns.charts[field].carriers.empty())
    join_hanging_nodes(discretization.hanging, values);
}
} // namespace pellicle
