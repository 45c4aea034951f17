// SPDX-License-Identifier: LGPL-2.1-or-later
// Shells for the tests.
#pragma once

#include <pellicle/models/shell_scene.h>
#include <pellicle/potentials/shell/cosserat_shell.h>
#include <pellicle/potentials/shell/shell_loads.h>

#include "equilibrium_runs.h"

#include <string>

namespace pellicle::test
{
inline ShellScene shell_scene(const std::string &shape, const std::string &load, const int degree,
                              const int refinements)
{
  ShellScene scene       = make_shell_scene(director_effects(), {"cosserat shell", load}, {});
  scene.shell.shape      = shape;
  scene.mesh.degree      = degree;
  scene.mesh.refinements = refinements;
  return scene;
}

/** The hemisphere with a hole of 18 degrees of MacNeal & Harder (Finite Elem. Anal. Des. 1, 3, 1985): R = 10, t = .04,
 * E = 6.825e7, nu = .3, two pairs of forces on the equator. On their quarter each force is 1: a node on a plane of
 * symmetry carries half of the force F = 2 of the whole. */
inline ShellScene pinched_hemisphere(const double force, const int degree, const int refinements)
{
  ShellScene scene                                 = shell_scene("hemisphere", "point loads", degree, refinements);
  scene.shell.radius                               = 10.;
  scene.shell.angle                                = 18.;
  ShellMaterial &shell                             = effect<CosseratShellEffect>(scene).parameters;
  shell.young                                      = 6.825e7;
  shell.poisson                                    = 0.3;
  shell.thickness                                  = 0.04;
  effect<PointLoadsEffect>(scene).parameters.force = force;
  return scene;
}
} // namespace pellicle::test
