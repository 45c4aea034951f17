// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/surface_discretization.h>

namespace pellicle
{
namespace
{
constexpr unsigned int most_nodes = 80; ///< of a cell: degree 3 in a body, with its pressure nodes

/** sum_I table(s, q, I) v_I for all slots of all points. The number of slots is known to the compiler, so that the sums
 * of a point (3 to 18 of them, independent of each other) stay in registers. */
template <unsigned int n_slots>
void contract(const ShapeTables &tables, const double *nodal, double *inputs)
{
  const unsigned int n_nodes = tables.n_nodes;
  for (unsigned int q = 0; q < tables.n_points; ++q)
  {
    const double *rows[n_slots];
    for (unsigned int s = 0; s < n_slots; ++s)
      rows[s] = tables.tables[s].data() + std::size_t(q) * n_nodes;

    double sums[n_slots][3] = {};
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int s = 0; s < n_slots; ++s)
      {
        const double weight = rows[s][i];
        sums[s][0] += weight * nodal[3 * i];
        sums[s][1] += weight * nodal[3 * i + 1];
        sums[s][2] += weight * nodal[3 * i + 2];
      }

    double *const at_point = inputs + std::size_t(q) * 18;
    for (unsigned int s = 0; s < n_slots; ++s)
      for (unsigned int c = 0; c < 3; ++c)
        at_point[3 * s + c] = sums[s][c];
  }
}

/** v <- map v for every slot of every point. */
void apply_maps(const ShapeTables &tables, const unsigned int n_slots, double *inputs)
{
  for (unsigned int q = 0; q < tables.n_points; ++q)
    for (unsigned int s = 0; s < n_slots; ++s)
    {
      const std::array<double, 9> &m = tables.map[s];
      double *const v                = inputs + (std::size_t(q) * 6 + s) * 3;
      const double x = v[0], y = v[1], z = v[2];
      for (unsigned int c = 0; c < 3; ++c)
        v[c] = m[3 * c] * x + m[3 * c + 1] * y + m[3 * c + 2] * z;
    }
}
} // namespace

void evaluate_field(const ShapeTables &tables, const std::size_t *cell_nodes, const NodalVectors &values,
                    const unsigned int n_slots, double *inputs)
{
  PELLICLE_ASSERT(n_slots >= 1 && n_slots <= 6, "a field has one to six slots");
  PELLICLE_ASSERT(tables.n_nodes <= most_nodes, "degree too high");
  double nodal[3 * most_nodes];
  for (unsigned int i = 0; i < tables.n_nodes; ++i)
    for (unsigned int c = 0; c < 3; ++c)
      nodal[3 * i + c] = values[3 * cell_nodes[i] + c];

  switch (n_slots)
  {
  case 1:
    contract<1>(tables, nodal, inputs);
    break;
  case 2:
    contract<2>(tables, nodal, inputs);
    break;
  case 3:
    contract<3>(tables, nodal, inputs);
    break;
  case 4:
    contract<4>(tables, nodal, inputs);
    break;
  case 5:
    contract<5>(tables, nodal, inputs);
    break;
  default:
    contract<6>(tables, nodal, inputs);
    break;
  }
  if (!tables.identity_map)
    apply_maps(tables, n_slots, inputs);
}
} // namespace pellicle
