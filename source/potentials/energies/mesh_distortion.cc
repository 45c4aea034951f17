// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/mesh_distortion.h>

namespace pellicle
{
void MeshDistortion::add_derivatives(const PointInputs<double, 1> &inputs, const PointData &data,
                                     const PointDerivativeView &view) const
{
  const StretchDerivatives stretch(inputs[0], (*reference)[data.index]);
  const double T = stretch.T, s = stretch.s;
  InvariantDerivatives W; // of T/(2 s) - 1 + w (s - 1)^2
  W.T  = 1. / (2. * s);
  W.s  = -T / (2. * s * s) + 2. * area_weight * (s - 1.);
  W.Ts = -1. / (2. * s * s);
  W.ss = T / (s * s * s) + 2. * area_weight;
  stretch.add(W, 0, view);
}

std::shared_ptr<const Potential> make_mesh_distortion(std::vector<ReferenceMetric> reference)
{
  return std::make_shared<DensityPotential<MeshDistortion>>(
      "mesh distortion", MeshDistortion{std::make_shared<const std::vector<ReferenceMetric>>(std::move(reference))});
}
} // namespace pellicle
