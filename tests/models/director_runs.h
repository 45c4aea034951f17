// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes of directors for the tests: K = 1.
#pragma once

#include "equilibrium_runs.h"

#include <pellicle/models/director_scene.h>
#include <pellicle/potentials/director/director_effect.h>
#include <pellicle/potentials/potential_library.h>

#include <limits>

namespace pellicle::test
{
constexpr double infinite = std::numeric_limits<double>::infinity();

struct DirectorMesh
{
  const char *symmetry;
  int degree, refinements;
};

/** Directors of tilt modulus k_t on a start shape of area 4 pi, which is held unless further effects say otherwise. */
template <typename Scene = DirectorScene>
Scene director_scene(const std::string &start_shape, const DirectorMesh &mesh, const double k_t,
                     const std::vector<std::string> &further = {}, const std::vector<std::string> &analyses = {})
{
  Scene scene;
  std::vector<std::string> effects{"director"};
  effects.insert(effects.end(), further.begin(), further.end());
  list_effects(scene, director_effects(), effects, analyses);
  scene.stability.eigenvalues                           = 0;
  scene.carrier.motion                                  = further.empty() ? "held" : "free";
  scene.vesicle.start_shape                             = start_shape;
  scene.vesicle.semi_axes                               = {1., 1., 1.};
  scene.mesh.symmetry                                   = mesh.symmetry;
  scene.mesh.degree                                     = mesh.degree;
  scene.mesh.refinements                                = mesh.refinements;
  effect<DirectorEffect>(scene).parameters.tilt_modulus = k_t;
  return scene;
}

/** Clifford's torus with r = 1. */
inline DirectorScene on_torus(const int refinements, const double k_t, const std::string &shear = "mixed")
{
  DirectorScene scene                            = director_scene("torus", {"none", 3, refinements}, k_t);
  scene.vesicle.area                             = 4. * pi * pi * std::sqrt(2.);
  effect<DirectorEffect>(scene).parameters.shear = shear;
  return scene;
}

/** Around a disc of radius 1 in a flat membrane of radius 20. */
inline DirectorScene around_disc(const DirectorMesh &mesh, const double tilt, const double k_t = 1.)
{
  DirectorScene scene       = director_scene("ellipsoid", mesh, k_t);
  scene.carrier.shape       = "inclusion";
  scene.inclusion.edge_tilt = tilt;
  return scene;
}

/** A model as it starts. */
class Unsolved
{
public:
  explicit Unsolved(const SurfaceScene &scene)
      : model(scene, communicator, timing)
  {
  }
  double quantity(const std::string &name) const { return test::quantity(model, name); }

private:
  Communicator communicator;
  Timing timing;

public:
  SurfaceModel model;
};

inline NodalVectors directors_of(const SurfaceModel &model)
{
  const SurfaceProblem &problem = model.equilibrium();
  return problem.state().fields[problem.layout().index("director")];
}
} // namespace pellicle::test
