// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/apps/surface_application.h>
#include <pellicle/models/ridge_scene.h>

int main(int argc, char **argv)
{
  return pellicle::run_surface_application(argc, argv,
                                           {"wetting_ridge",
                                            "Drops on soft solids: a hyperelastic substrate with surface tensions, a "
                                            "pinned or a free contact line.",
                                            pellicle::ridge_effects(),
                                            {"liquid surface", "volume constraint", "solid", "solid skins"},
                                            [](const auto & /*effects*/)
                                            { return std::make_unique<pellicle::RidgeScene>(); }});
}
