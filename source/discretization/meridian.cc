// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meridian_line.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/builders.h>

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

#include <cmath>

namespace pellicle
{
SurfaceDiscretization on_meridian(const SmoothShape &shape, const unsigned int degree, const Refinement &refinement,
                                  const bool mirror)
{
  PELLICLE_ASSERT(shape.axisymmetric && (shape.up_down_symmetric || !mirror), "the shape has no such meridian");
  const std::size_t n_cells = std::size_t(mirror ? 2 : 4) << refinement.uniform;
  const double end          = mirror ? 0.5 : 1.; // polar angle in units of pi
  const auto direction      = [&](const double t)
  {
    const double angle = end * t / n_cells;
    return Vector3<double>(boost::math::sin_pi(angle), 0., boost::math::cos_pi(angle));
  };

  SurfaceDiscretization result =
      meridian_line(degree, n_cells, refinement.cut, mirror, [&](const double t) { return shape.point(direction(t)); });
  result.mesh_reference = result.positions;
  if (shape.even_mesh == SmoothShape::EvenMesh::sphere)
  {
    const double radius = std::sqrt(shape.area / (4. * pi));
    result.mesh_reference =
        meridian_line(degree, n_cells, refinement.cut, mirror, [&](const double t) { return radius * direction(t); })
            .positions;
  }

  put_on_axis(result, 0);
  if (mirror)
    put_on_mirror(result, result.n_nodes - 1);
  else
  {
    put_on_axis(result, result.n_nodes - 1);
    free_along_axis(result);
  }
  return result;
}
} // namespace pellicle
