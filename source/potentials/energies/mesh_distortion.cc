// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/mesh_distortion.h>

namespace pellicle
{
std::shared_ptr<const Potential> make_mesh_distortion(std::vector<ReferenceMetric> reference)
{
  return std::make_shared<DensityPotential<MeshDistortion>>(
      "mesh distortion", MeshDistortion{std::make_shared<const std::vector<ReferenceMetric>>(std::move(reference))});
}
} // namespace pellicle
