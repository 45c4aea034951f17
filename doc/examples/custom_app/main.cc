// SPDX-License-Identifier: LGPL-2.1-or-later
// A main of one's own: the library's effects and one more, parameters set in the program instead of a scene file.
// Solves for a closed membrane of fixed area in a soft and in a stiff confinement.
#include "confinement.h"

#include <pellicle/models/surface_model.h>
#include <pellicle/models/vesicle_scene.h>

#include <deal.II/base/mpi.h>

#include <cstdio>
#include <stdexcept>

namespace
{
/** Integral of z^2 dA over the equilibrium shape in a confinement of the given stiffness k. */
double spread(const pellicle::EffectLibrary &library, const double stiffness)
{
  pellicle::VesicleScene scene =
      pellicle::make_vesicle_scene(library, {"helfrich bending", "area constraint", "confinement"}, {});
  scene.mesh.degree            = 2;
  scene.mesh.refinements       = 1;
  scene.vesicle.start_shape    = "oblate";
  scene.vesicle.reduced_volume = 0.9; // of the start shape: no constraint holds it

  auto &confinement                = dynamic_cast<custom::ConfinementEffect &>(*scene.effects.back());
  confinement.parameters.stiffness = stiffness;
  scene.check();

  pellicle::Timing timing;
  pellicle::Observer silent;
  const pellicle::Communicator communicator;
  pellicle::SurfaceModel model(scene, communicator, timing);
  const pellicle::StepResult result = model.solve(1, silent);
  if (!result.converged)
    throw std::runtime_error(result.failure);

  // Energies stand in the order of the list, in internal units; ours is the last one, (k/2) times what is wanted.
  const double energy = model.equilibrium().values().energies.back() * model.scales().energy;
  return 2. * energy / stiffness;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
  {
    pellicle::EffectLibrary library = pellicle::standard_effects();
    library.add("confinement", [] { return std::make_unique<custom::ConfinementEffect>(); });

    // Of two minimisers the one with the larger k has the smaller integral, and both have less than the sphere, which
    // is best for k = 0.
    const double soft = spread(library, 1.), stiff = spread(library, 10.);
    const double sphere = 4. * 3.14159265358979323846 / 3.;
    std::printf("integral of z^2 dA: sphere %.6f, soft %.6f, stiff %.6f\n", sphere, soft, stiff);
    return stiff < 0.8 * soft && soft < 0.95 * sphere ? 0 : 1;
  }
  catch (const std::exception &error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
