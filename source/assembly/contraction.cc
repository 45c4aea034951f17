// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/contraction.h>

#include <algorithm>
#include <utility>

extern "C" void dgemm_(const char *transa, const char *transb, const int *m, const int *n, const int *k,
                       const double *alpha, const double *a, const int *lda, const double *b, const int *ldb,
                       const double *beta, double *c, const int *ldc);

namespace pellicle
{
Contraction::Contraction(const ShapeTables &tables, const FieldLayout &layout, std::vector<bool> active_fields)
    : tables(tables)
    , fields(layout.fields())
    , active(std::move(active_fields))
    , n_points(tables.n_points)
    , n_nodes(tables.n_nodes)
    , rows(3 * static_cast<unsigned int>(fields.size()) * tables.n_nodes)
{
  unsigned int max_slots = 1;
  for (const Field &field : fields)
    max_slots = std::max(max_slots, field.n_slots);
  for (unsigned int s = 0; s < max_slots; ++s)
    stacked.insert(stacked.end(), tables.tables[s].begin(), tables.tables[s].end());
}

void Contraction::gradient(const PointSums &sums, std::vector<double> &gradient) const
{
  gradient.assign(rows, 0.);
  for (unsigned int f = 0; f < fields.size(); ++f)
  {
    if (!active[f])
      continue;
    for (unsigned int s = 0; s < fields[f].n_slots; ++s)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const double *g = sums.gradient.data() + std::size_t(q) * sums.n_inputs + fields[f].offset + 3 * s;
        const double *N = table(s) + std::size_t(q) * n_nodes;
        double mapped[3];
        if (tables.identity_map)
          std::copy(g, g + 3, mapped);
        else
          for (unsigned int c = 0; c < 3; ++c)
            mapped[c] = tables.map[s][c] * g[0] + tables.map[s][3 + c] * g[1] + tables.map[s][6 + c] * g[2];
        for (unsigned int c = 0; c < 3; ++c)
        {
          const double w       = tables.weights[q] * mapped[c];
          double *const target = gradient.data() + (3 * f + c) * n_nodes;
          for (unsigned int I = 0; I < n_nodes; ++I)
            target[I] += w * N[I];
        }
      }
  }
}

// H_{s s'} -> map[s]^T H_{s s'} map[s']: afterwards the inputs are plain sums of tables times nodal values again.
void Contraction::apply_map(PointSums &sums) const
{
  const unsigned int n = sums.n_inputs;
  const auto transform =
      [&](double *h, const std::size_t stride_row, const std::size_t stride_column, const unsigned int s)
  {
    // Replaces the three entries along the row direction by map[s]^T times them, for every column.
    for (unsigned int j = 0; j < n; ++j)
    {
      double *const column = h + j * stride_column;
      const double v[3]    = {column[0], column[stride_row], column[2 * stride_row]};
      for (unsigned int c = 0; c < 3; ++c)
        column[c * stride_row] = tables.map[s][c] * v[0] + tables.map[s][3 + c] * v[1] + tables.map[s][6 + c] * v[2];
    }
  };
  for (unsigned int q = 0; q < n_points; ++q)
  {
    double *const h = sums.hessian.data() + std::size_t(q) * n * n;
    for (const Field &field : fields)
      for (unsigned int s = 0; s < field.n_slots; ++s)
      {
        const unsigned int first = field.offset + 3 * s;
        transform(h + std::size_t(first) * n, n, 1, s);
        transform(h + first, 1, n, s);
      }
  }
}

// For each row block (f, c): first C[s, q][column block, J] = sum_s' w_q H[q][f s c][f' s' c'] T_s'(q, J), then one
// dense product T^T C. Blocks that are zero at all points (most of the moment's) are left out.
void Contraction::matrix(PointSums &sums, std::vector<double> &matrix)
{
  matrix.assign(std::size_t(rows) * rows, 0.);
  if (!tables.identity_map)
    apply_map(sums);
  const unsigned int n = sums.n_inputs, n_blocks = 3 * static_cast<unsigned int>(fields.size());

  std::vector<double> product;
  std::vector<unsigned int> columns;
  for (unsigned int row = 0; row < n_blocks; ++row)
  {
    const Field &row_field = fields[row / 3];
    if (!active[row / 3])
      continue;
    // Which slots of this row and which column blocks hold anything?
    const unsigned int slots = row_field.n_slots;
    unsigned int first_slot = slots, last_slot = 0;
    columns.clear();
    for (unsigned int column = row; column < n_blocks; ++column)
    {
      if (!active[column / 3])
        continue;
      const Field &column_field = fields[column / 3];
      bool any                  = false;
      for (unsigned int s = 0; s < slots; ++s)
      {
        bool any_in_slot = false;
        for (unsigned int q = 0; q < n_points && !any_in_slot; ++q)
        {
          const double *h = sums.hessian.data() + (std::size_t(q) * n + row_field.offset + 3 * s + row % 3) * n +
                            column_field.offset + column % 3;
          for (unsigned int t = 0; t < column_field.n_slots; ++t)
            any_in_slot = any_in_slot || h[3 * t] != 0.;
        }
        if (any_in_slot)
        {
          any        = true;
          first_slot = std::min(first_slot, s);
          last_slot  = std::max(last_slot, s);
        }
      }
      if (any)
        columns.push_back(column);
    }
    if (columns.empty())
      continue;

    const unsigned int n_row_slots = last_slot - first_slot + 1;
    const std::size_t width        = columns.size() * n_nodes;
    half_contracted.assign(std::size_t(n_row_slots) * n_points * width, 0.);
    for (unsigned int s = 0; s < n_row_slots; ++s)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const double *h_row =
            sums.hessian.data() + (std::size_t(q) * n + row_field.offset + 3 * (first_slot + s) + row % 3) * n;
        double *C = half_contracted.data() + (std::size_t(s) * n_points + q) * width;
        for (const unsigned int column : columns)
        {
          const Field &column_field = fields[column / 3];
          for (unsigned int t = 0; t < column_field.n_slots; ++t)
          {
            const double h = tables.weights[q] * h_row[column_field.offset + 3 * t + column % 3];
            if (h == 0.)
              continue;
            const double *N = table(t) + std::size_t(q) * n_nodes;
            for (unsigned int J = 0; J < n_nodes; ++J)
              C[J] += h * N[J];
          }
          C += n_nodes;
        }
      }

    // product (n_nodes x width, row-major) = T^T C; in the column-major terms of BLAS: product^T = C^T T.
    product.resize(n_nodes * width);
    const int m = static_cast<int>(width), nn = static_cast<int>(n_nodes), k = static_cast<int>(n_row_slots * n_points);
    const double one = 1., zero = 0.;
    dgemm_("N", "T", &m, &nn, &k, &one, half_contracted.data(), &m, table(first_slot), &nn, &zero, product.data(), &m);

    for (std::size_t b = 0; b < columns.size(); ++b)
      for (unsigned int I = 0; I < n_nodes; ++I)
        for (unsigned int J = 0; J < n_nodes; ++J)
        {
          const double value  = product[I * width + b * n_nodes + J];
          const std::size_t i = std::size_t(row) * n_nodes + I, j = std::size_t(columns[b]) * n_nodes + J;
          matrix[i * rows + j] = value;
          matrix[j * rows + i] = value;
        }
  }
}
} // namespace pellicle
