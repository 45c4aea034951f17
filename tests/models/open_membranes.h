// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes of open membranes.
#pragma once

#include "equilibrium_runs.h"

#include <pellicle/discretization/edge_loops.h>
#include <pellicle/potentials/edges/gaussian_curvature.h>
#include <pellicle/potentials/edges/line_tension.h>

#include <set>

namespace pellicle::test
{
struct OpenMesh
{
  const char *symmetry;
  int degree, refinements;
};

inline VesicleScene open_scene(const std::vector<std::string> &effects, const std::string &start_shape,
                               const std::string &rim, const OpenMesh &mesh)
{
  VesicleScene scene        = scene_with(effects);
  scene.vesicle.start_shape = start_shape;
  scene.vesicle.rim         = rim;
  scene.mesh.symmetry       = mesh.symmetry;
  scene.mesh.degree         = mesh.degree;
  scene.mesh.refinements    = mesh.refinements;
  return scene;
}

inline const EdgeLoop &loop_named(const Solved &solved, const std::string &name)
{
  for (const EdgeLoop &loop : solved.model.mesh().edges)
    if (loop.name == name)
      return loop;
  throw std::logic_error("the surface has no edge " + name);
}
} // namespace pellicle::test
