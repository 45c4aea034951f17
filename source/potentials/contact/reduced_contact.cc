// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/contact/contact_law.h>
#include <pellicle/potentials/contact/reduced_contact.h>
#include <pellicle/potentials/surface_measures.h>

namespace pellicle
{
ReducedContact reduced_contact(const RigidBody &body, const std::array<double, n_reduced_contact_inputs> &inputs,
                               const double penalty)
{
  constexpr unsigned int n = n_reduced_contact_inputs, p = n - 1;
  const Vector3<double> x{inputs[0], inputs[1], inputs[2]};
  const AreaDerivatives area({inputs[3], inputs[4], inputs[5]}, {inputs[6], inputs[7], inputs[8]});
  const double multiplier = inputs[p];
  const GapSample sample  = body.gap(x);
  const ContactResponse response(sample.gap, multiplier, penalty);

  // Residual per area, and its derivatives with respect to x and p.
  std::array<double, n> per_area{};
  ReducedContact result;
  const auto K = [&](const unsigned int i, const unsigned int j) -> double & { return result.tangent[i * n + j]; };
  for (unsigned int i = 0; i < 3; ++i)
  {
    per_area[i] = -response.pressure * sample.normal[i];
    for (unsigned int j = 0; j < 3; ++j)
      K(i, j) = area.J *
                (response.stiffness * sample.normal[i] * sample.normal[j] - response.pressure * sample.hessian(i, j));
    K(i, p) = K(p, i) = -area.J * response.stiffness / penalty * sample.normal[i];
  }
  per_area[p] = (response.pressure - multiplier) / penalty;
  K(p, p)     = area.J * (response.stiffness / penalty - 1.) / penalty;

  for (unsigned int i = 0; i < n; ++i)
  {
    result.residual[i] = area.J * per_area[i];
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int c = 0; c < 3; ++c)
        K(i, 3 + 3 * a + c) += per_area[i] * area.dJ[a][c];
  }
  return result;
}
} // namespace pellicle
