// SPDX-License-Identifier: LGPL-2.1-or-later
// A main of one's own: the library's effects and one more, parameters set in the program instead of a scene file.
// Solves for an oblate vesicle with and without the confinement; the confined one must be flatter.
#include "confinement.h"

#include <pellicle/models/surface_model.h>

#include <deal.II/base/mpi.h>

#include <cstdio>
#include <stdexcept>

namespace
{
/** Height of the equilibrium shape with a given stiffness of the confinement; none: not even listed. */
double height(const pellicle::EffectLibrary &library, const std::optional<double> stiffness)
{
  std::vector<std::string> effects{"helfrich bending", "area constraint", "volume constraint"};
  if (stiffness)
    effects.emplace_back("confinement");

  pellicle::SurfaceScene scene = pellicle::make_surface_scene(library, effects, {});
  scene.mesh.degree            = 2;
  scene.mesh.refinements       = 1;
  scene.vesicle.start_shape    = "oblate";
  scene.vesicle.reduced_volume = 0.9;
  if (stiffness)
    dynamic_cast<custom::ConfinementEffect &>(*scene.effects.back()).parameters.stiffness = *stiffness;
  scene.check();

  pellicle::Timing timing;
  pellicle::Observer silent;
  const pellicle::Communicator communicator;
  pellicle::SurfaceModel model(scene, communicator, timing);
  const pellicle::StepResult result = model.solve(1, silent);
  if (!result.converged)
    throw std::runtime_error(result.failure);
  for (const auto &[name, value] : model.quantities())
    if (name == "height")
      return value;
  throw std::runtime_error("the model reports no height");
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
  {
    pellicle::EffectLibrary library = pellicle::standard_effects();
    library.add("confinement", [] { return std::make_unique<custom::ConfinementEffect>(); });

    const double free = height(library, {}), confined = height(library, 10.);
    std::printf("height of the vesicle: free %.6f, confined %.6f\n", free, confined);
    return confined < 0.99 * free ? 0 : 1;
  }
  catch (const std::exception &error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
