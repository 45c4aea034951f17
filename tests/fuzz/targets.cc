// SPDX-License-Identifier: LGPL-2.1-or-later
#include "targets.h"

namespace pellicle::fuzz
{
const std::vector<Target> &targets()
{
  static const std::vector<Target> list = {{"checkpoint", read_checkpoint}, {"command_line", read_command_line},
                                           {"expression", read_expression}, {"mesh", read_mesh},
                                           {"model", read_model},           {"scene", read_scene}};
  return list;
}
} // namespace pellicle::fuzz
