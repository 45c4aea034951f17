// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/phase_diagram.h>
#include <pellicle/models/vesicle_scene.h>

int main(int argc, char **argv)
{
  return pellicle::run_surface_application(argc, argv,
                                           {"vesicle",
                                            "Equilibrium shapes of closed membranes: Helfrich bending under "
                                            "constraints of area and volume, tension and pressure.",
                                            pellicle::standard_effects(),
                                            {"helfrich bending", "area constraint", "volume constraint"},
                                            [](const auto & /*effects*/)
                                            { return std::make_unique<pellicle::VesicleScene>(); },
                                            {{"phase diagram", pellicle::run_phase_diagram}}});
}
