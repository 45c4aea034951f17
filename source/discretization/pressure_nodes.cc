// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/bodies.h>
#include <pellicle/discretization/refined_quads.h>

#include <boost/math/special_functions/legendre.hpp>

#include <cmath>

namespace pellicle
{
namespace
{
/** Coordinates in [-1, 1] of the points of a body's tables; the third is 0 in the half plane. */
std::vector<std::array<double, 3>> points_of(const ShapeTables &tables, const unsigned int degree,
                                             const unsigned int dimension)
{
  const std::vector<double> line = line_nodes(degree);
  std::vector<std::array<double, 3>> points(tables.n_points, {{0., 0., 0.}});
  for (unsigned int q = 0; q < tables.n_points; ++q)
    for (unsigned int I = 0; I < tables.n_nodes; ++I)
    {
      unsigned int rest = I;
      for (unsigned int d = 0; d < dimension; ++d, rest /= line.size())
        points[q][d] += tables.tables[0][std::size_t(q) * tables.n_nodes + I] * line[rest % line.size()];
    }
  return points;
}

/** Exponents with a sum of at most `degree`. */
std::vector<std::array<unsigned int, 3>> complete_polynomials(const unsigned int degree, const unsigned int dimension)
{
  std::vector<std::array<unsigned int, 3>> list;
  for (unsigned int l = 0; l <= (dimension == 3 ? degree : 0); ++l)
    for (unsigned int j = 0; j + l <= degree; ++j)
      for (unsigned int i = 0; i + j + l <= degree; ++i)
        list.push_back({{i, j, l}});
  return list;
}

/** values[q * n_old + i] -> the same with further columns further(q, j). */
template <typename Further>
void append_columns(std::vector<double> &values, const std::size_t n_old, const std::size_t n_further,
                    const Further &further)
{
  std::vector<double> result;
  for (std::size_t q = 0; q * n_old < values.size(); ++q)
  {
    result.insert(result.end(), values.begin() + q * n_old, values.begin() + (q + 1) * n_old);
    for (std::size_t j = 0; j < n_further; ++j)
      result.push_back(further(q, j));
  }
  values = std::move(result);
}
} // namespace

void add_pressure_nodes(SurfaceDiscretization &discretization, const std::size_t number)
{
  BulkPart &body = discretization.bulks[number];
  PELLICLE_ASSERT(body.n_pressure_nodes == 0, "a body has its pressure nodes once");
  const unsigned int dimension = discretization.kind == SurfaceDiscretization::Kind::surface ? 3 : 2;
  const auto points            = points_of(body.tables, discretization.degree, dimension);
  const auto modes             = complete_polynomials(discretization.degree - 1, dimension);
  ShapeTables &tables          = body.tables;

  for (unsigned int s = 0; s < tables.tables.size(); ++s)
    append_columns(tables.tables[s], tables.n_nodes, modes.size(),
                   [&](const std::size_t q, const std::size_t j)
                   {
                     double value = s == 0 ? 1. : 0.; // pressures are not differentiated
                     for (unsigned int d = 0; d < dimension; ++d)
                       value *= boost::math::legendre_p(static_cast<int>(modes[j][d]), points[q][d]);
                     return value;
                   });
  std::vector<std::size_t> cell_nodes;
  for (std::size_t c = 0; c < body.n_cells; ++c)
  {
    const auto first = body.cell_nodes.begin() + c * tables.n_nodes;
    cell_nodes.insert(cell_nodes.end(), first, first + tables.n_nodes);
    for (std::size_t j = 0; j < modes.size(); ++j)
      cell_nodes.push_back(discretization.n_nodes + c * modes.size() + j);
  }
  body.cell_nodes       = std::move(cell_nodes);
  body.n_pressure_nodes = static_cast<unsigned int>(modes.size());
  tables.n_nodes += body.n_pressure_nodes;

  discretization.admissible.resize(discretization.n_nodes);
  AdmissibleDirections none;
  none.count   = 0;
  none.columns = {};
  discretization.n_nodes += body.n_cells * modes.size();
  discretization.admissible.resize(discretization.n_nodes, none);
  discretization.positions.resize(3 * discretization.n_nodes, 0.);
  discretization.mesh_reference.resize(3 * discretization.n_nodes, 0.);
}
} // namespace pellicle
