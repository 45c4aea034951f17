// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/surface_application.h>
#include <pellicle/models/droplet_scene.h>

int main(int argc, char **argv)
{
  return pellicle::run_surface_application(argc, argv,
                                           {"droplet_contact",
                                            "Quasi-static drops and liquid membranes in contact with rigid and "
                                            "deformable bodies.",
                                            pellicle::droplet_effects(),
                                            {"liquid surface", "volume constraint", "wetting"},
                                            [](const auto & /*effects*/)
                                            { return std::make_unique<pellicle::DropletScene>(); }});
}
