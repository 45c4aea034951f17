// SPDX-License-Identifier: LGPL-2.1-or-later
// Vesicles for the tests: a scene, its model, and what its iterations reported.
#pragma once

#include <pellicle/base/constants.h>
#include <pellicle/models/shape_measures.h>
#include <pellicle/models/surface_model.h>
#include <pellicle/models/vesicle_scene.h>
#include <pellicle/potentials/constraints/total_area.h>
#include <pellicle/potentials/energies/helfrich_bending.h>
#include <pellicle/potentials/energies/pressure.h>
#include <pellicle/potentials/energies/surface_tension.h>

#include "../mpi_environment.h"
#include "../record.h"

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace pellicle::test
{
/** A scene with default parameters: area 4 pi, kappa 1, so that the user's units are the internal ones. Equilibria are
 * told from saddles by the number of negative eigenvalues; modes are not computed. */
inline VesicleScene scene_with(const std::vector<std::string> &effects)
{
  VesicleScene scene          = make_vesicle_scene(standard_effects(), effects, {"stability"});
  scene.stability.eigenvalues = 0;
  return scene;
}

template <typename EffectType>
EffectType &effect(SurfaceScene &scene)
{
  for (const auto &listed : scene.effects)
    if (auto *found = dynamic_cast<EffectType *>(listed.get()))
      return *found;
  throw std::logic_error("the effect is not in the scene");
}

/** Bending under fixed area and volume: the vesicle of Seifert, Berndl & Lipowsky, Phys. Rev. A 44, 1182 (1991). */
inline VesicleScene vesicle(const std::string &start_shape, const double reduced_volume, const int degree,
                            const int refinements, const std::string &symmetry = "none")
{
  VesicleScene scene           = scene_with({"helfrich bending", "area constraint", "volume constraint"});
  scene.vesicle.start_shape    = start_shape;
  scene.vesicle.reduced_volume = reduced_volume;
  scene.mesh.degree            = degree;
  scene.mesh.refinements       = refinements;
  scene.mesh.symmetry          = symmetry;
  return scene;
}

/** A reported quantity by its name, in the user's units. */
inline double quantity(const SurfaceModel &model, const std::string &name)
{
  for (const auto &[reported, value] : model.quantities())
    if (reported == name)
      return value;
  throw std::logic_error("the model does not report " + name);
}

inline double relative_error(const double value, const double exact)
{
  return std::abs(value / exact - 1.);
}

/** A model that has been solved once. */
class Solved
{
public:
  explicit Solved(const SurfaceScene &scene)
      : model(scene, communicator, timing)
      , result(model.solve(1, record))
      , seconds(timing.total())
  {
  }

  /** E/(8 pi kappa), internal units with kappa = 1. */
  double energy() const { return model.equilibrium().energy() / (8. * pi); }
  double sigma() const { return model.equilibrium().state().multipliers[0]; }
  double pressure() const { return -model.equilibrium().state().multipliers[1]; }
  const NodalVectors &positions() const { return model.equilibrium().state().fields[0]; }
  double quantity(const std::string &name) const { return test::quantity(model, name); }
  int negative_eigenvalues() const { return model.stability().value().negative_eigenvalues; }
  ShapeMeasures shape() const { return measure_shape(model.mesh(), positions()); }

  Communicator communicator;
  Timing timing;
  Record record;
  SurfaceModel model;
  StepResult result;
  double seconds;
};

/** Load steps as the application takes them, from an equilibrium: scene(t) for t from 0 (that of the model) to 1.
 * Returns the last t that was reached; `solved.result` is that of the last attempt. */
template <typename SceneAt>
double walk(Solved &solved, const int steps, const SceneAt &scene)
{
  LoadParameters load;
  load.steps = steps;
  int number = 1;
  return walk_load(load,
                   [&](const double t)
                   {
                     if (t > 0.)
                     {
                       solved.model.update(scene(t));
                       solved.result = solved.model.solve(++number, solved.record);
                     }
                     return solved.result.converged;
                   });
}

/** Quadratic convergence: from the first residual below `small` on, each is at most
 * factor * (the one before)^2, or at round-off. Needs at least one such pair. */
inline void expect_quadratic_tail(const std::vector<IterationReport> &iterations, const double small,
                                  const double factor, const double round_off)
{
  int n_pairs = 0;
  for (std::size_t i = 1; i < iterations.size(); ++i)
  {
    const double before = iterations[i - 1].relative_residual, now = iterations[i].relative_residual;
    if (before > small)
      continue;
    ++n_pairs;
    EXPECT_LE(now, factor * before * before + round_off) << "iteration " << iterations[i].iteration;
  }
  EXPECT_GE(n_pairs, 1);
}
} // namespace pellicle::test
