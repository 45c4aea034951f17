// SPDX-License-Identifier: LGPL-2.1-or-later
#include "targets.h"

#include <pellicle/base/exceptions.h>
#include <pellicle/base/text.h>

#include <stdexcept>

namespace pellicle::fuzz
{
void run(Reader *read, const std::string &input)
{
  const auto check = [](const std::exception &refusal)
  {
    if (trimmed(refusal.what()).empty())
      throw std::logic_error("refused without a word");
  };
  try
  {
    read(input);
  }
  catch (const UserError &refusal)
  {
    check(refusal);
  }
  catch (const SolveError &refusal)
  {
    check(refusal);
  }
}
} // namespace pellicle::fuzz
