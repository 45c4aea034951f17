// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/mesh_distortion.h>

namespace pellicle
{
// f = J0 (T/(2 s) - 1 + w (s - 1)^2) with s = J/J0 and T = tr C, quadratic in x,a.
void MeshDistortion::add_derivatives(const PointInputs<double, 1> &inputs, const PointData &data,
                                     const PointDerivativeView &view) const
{
  const ReferenceMetric &A  = (*reference)[data.index];
  const double J0_squared   = A.A11 * A.A22 - A.A12 * A.A12;
  const double J0           = std::sqrt(J0_squared);
  const Vector3<double> &x1 = inputs[0].d1(), &x2 = inputs[0].d2();
  const AreaDerivatives area(x1, x2);
  const double s   = area.J / J0;
  const double T   = (A.A22 * dot(x1, x1) - 2. * A.A12 * dot(x1, x2) + A.A11 * dot(x2, x2)) / J0_squared;
  const double f_T = J0 / (2. * s), f_s = J0 * (2. * area_weight * (s - 1.) - T / (2. * s * s));

  const Vector3<double> T_x[2] = {(2. / J0_squared) * (A.A22 * x1 - A.A12 * x2),
                                  (2. / J0_squared) * (A.A11 * x2 - A.A12 * x1)};
  const Vector3<double> s_x[2] = {(1. / J0) * area.dJ[0], (1. / J0) * area.dJ[1]};
  for (unsigned int a = 0; a < 2; ++a)
    view.add_gradient(0, 1 + a, f_T * T_x[a] + f_s * s_x[a]);
  if (!view.wants_hessian())
    return;

  const double T_xx[3] = {2. * A.A22 / J0_squared, -2. * A.A12 / J0_squared, 2. * A.A11 / J0_squared};
  const double f_ss = J0 * (T / (s * s * s) + 2. * area_weight), f_sT = -J0 / (2. * s * s);
  for (unsigned int a = 0; a < 2; ++a)
    for (unsigned int b = a; b < 2; ++b)
      view.add_hessian(0, 1 + a, 0, 1 + b,
                       identity3(f_T * T_xx[a + b]) + (f_s / J0) * area.d2J(a, b) + f_ss * outer(s_x[a], s_x[b]) +
                           f_sT * (outer(T_x[a], s_x[b]) + outer(s_x[a], T_x[b])));
}

std::shared_ptr<const Potential> make_mesh_distortion(std::vector<ReferenceMetric> reference)
{
  return std::make_shared<DensityPotential<MeshDistortion>>(
      "mesh distortion", MeshDistortion{std::make_shared<const std::vector<ReferenceMetric>>(std::move(reference))});
}
} // namespace pellicle
