// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/shell/shell_reference.h>

namespace pellicle
{
ShellReference::ShellReference(const std::array<Vector3<double>, 3> &bases,
                               const std::array<Vector3<double>, 2> &director_derivatives, const Vector3<double> &X)
    : base(bases)
    , director_d(director_derivatives)
    , normal(cross(bases[0], bases[1]))
    , place(X)
    , area(dot(normal, bases[2]))
{
  PELLICLE_ASSERT(area > 0., "the director of a shell points to the side of its normal");
  for (unsigned int i = 0; i < 3; ++i)
    dual[i] = cross(bases[(i + 1) % 3], bases[(i + 2) % 3]) / area;
  normal          = normal / norm(normal);
  gauss_curvature = dot(cross(director_d[0], director_d[1]), base[2]) / area;
}

double ShellReference::volume(const double thickness) const
{
  return area * thickness * (1. + thickness * thickness / 12. * gauss_curvature);
}

std::array<Vector3<double>, 2> ShellReference::first_moments(const double thickness) const
{
  const double factor = thickness * thickness * thickness / 12. / volume(thickness);
  return {{factor * cross(director_d[1], base[2]), factor * cross(base[2], director_d[0])}};
}
} // namespace pellicle
