// SPDX-License-Identifier: LGPL-2.1-or-later
#include "targets.h"

#include <pellicle/base/exceptions.h>
#include <pellicle/base/text.h>

#include <stdexcept>

namespace pellicle::fuzz
{
const std::vector<Target> &targets()
{
  static const std::vector<Target> list = {{"command_line", read_command_line},
                                           {"expression", read_expression},
                                           {"mesh", read_mesh},
                                           {"scene", read_scene},
                                           {"validate", build_scene}};
  return list;
}

void run(const Target &target, const std::string &input)
{
  try
  {
    target.read(input);
  }
  catch (const UserError &refusal)
  {
    if (trimmed(refusal.what()).empty())
      throw std::logic_error("refused without a word");
  }
}
} // namespace pellicle::fuzz
