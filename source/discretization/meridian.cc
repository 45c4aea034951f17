// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/discretization/refined_quads.h>

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

namespace pellicle
{
namespace
{
constexpr std::array<double, 3> e_x{{1., 0., 0.}}, e_z{{0., 0., 1.}};

/** Columns beyond the count are zero. */
AdmissibleDirections directions(const std::vector<std::array<double, 3>> &columns)
{
  AdmissibleDirections result;
  result.count   = columns.size();
  result.columns = {};
  for (std::size_t i = 0; i < columns.size(); ++i)
    result.columns[i] = columns[i];
  return result;
}
} // namespace

SurfaceDiscretization on_meridian(const SmoothShape &shape, const unsigned int degree, const unsigned int refinements,
                                  const bool mirror)
{
  PELLICLE_ASSERT(shape.axisymmetric && (shape.up_down_symmetric || !mirror), "the shape has no such meridian");
  SurfaceDiscretization result;
  result.kind    = SurfaceDiscretization::Kind::meridian;
  result.degree  = degree;
  result.mirror  = mirror;
  result.n_cells = std::size_t(mirror ? 2 : 4) << refinements;
  result.n_nodes = degree * result.n_cells + 1;
  result.tables  = make_meridian_tables(degree, degree + 1, mirror);

  const std::vector<double> nodes = line_nodes(degree);
  const double end                = mirror ? 0.5 : 1.; // polar angle in units of pi
  result.positions.resize(3 * result.n_nodes, 0.);
  result.mesh_reference.resize(3 * result.n_nodes, 0.);
  const double radius = std::sqrt(shape.area / (4. * 3.141592653589793));
  result.admissible.resize(result.n_nodes, directions({e_x, e_z}));
  for (std::size_t cell = 0; cell < result.n_cells; ++cell)
    for (unsigned int i = 0; i <= degree; ++i)
    {
      const std::size_t node = cell * degree + i;
      result.cell_nodes.push_back(node);
      const double angle = end * (cell + 0.5 * (1. + nodes[i])) / result.n_cells;
      const Vector3<double> u(boost::math::sin_pi(angle), 0., boost::math::cos_pi(angle));
      const auto x = shape.point(u);
      for (unsigned int c = 0; c < 3; ++c)
        result.mesh_reference[3 * node + c] = shape.even_mesh == SmoothShape::EvenMesh::sphere ? radius * u[c] : x[c];

      result.positions[3 * node]     = x[0];
      result.positions[3 * node + 2] = x[2];
    }

  const auto on_axis = [&](const std::size_t node)
  {
    result.positions[3 * node] = 0.;
    result.admissible[node]    = directions({e_z});
  };
  on_axis(0);
  if (mirror)
  {
    result.positions[3 * (result.n_nodes - 1) + 2] = 0.;
    result.admissible.back()                       = directions({e_x});
  }
  else
  {
    on_axis(result.n_nodes - 1);
    result.rigid_motions.resize(1);
    result.rigid_motions[0].translation = e_z;
  }
  return result;
}
} // namespace pellicle
