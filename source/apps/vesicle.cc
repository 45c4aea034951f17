// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/surface_application.h>

int main(int argc, char **argv)
{
  return pellicle::run_surface_application(argc, argv,
                                           {"vesicle",
                                            "Equilibrium shapes of closed membranes: Helfrich bending under "
                                            "constraints of area and volume, tension and pressure.",
                                            pellicle::standard_effects(),
                                            {"helfrich bending", "area constraint", "volume constraint"}});
}
