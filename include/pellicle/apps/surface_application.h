// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/potentials/potential_library.h>

#include <string>
#include <vector>

namespace pellicle
{
/** What makes an application of the surface model: its name, the effects it offers and those it lists by default. */
struct SurfaceApplication
{
  std::string name;
  std::string description; ///< one or two sentences for --help
  EffectLibrary library;
  std::vector<std::string> default_effects;
};

/**
 * The whole of an application: command line, scene, model, load steps, files (doc of every part: the manual's interface
 * page). Initialises MPI if nobody has.
 *
 * @return exit status: 0 solved; 1 did not converge or refused to go on; 2 bad command line or scene.
 */
int run_surface_application(int argc, char **argv, const SurfaceApplication &application);
} // namespace pellicle
