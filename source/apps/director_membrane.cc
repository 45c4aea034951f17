// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/surface_application.h>
#include <pellicle/models/director_scene.h>

int main(int argc, char **argv)
{
  return pellicle::run_surface_application(argc, argv,
                                           {"director_membrane",
                                            "Membranes with directors (tilt of lipids) and Cosserat shells.",
                                            pellicle::director_effects(),
                                            {"director"},
                                            [] { return std::make_unique<pellicle::DirectorScene>(); }});
}
