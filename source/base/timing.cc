// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/timing.h>

namespace pellicle
{
Timing::Scope::Scope(Timing &timing, const std::string &name)
    : section(timing.sections[name])
{
  if (section.depth++ == 0)
    section.start = Clock::now();
}

Timing::Scope::~Scope()
{
  if (--section.depth == 0)
    section.seconds += std::chrono::duration<double>(Clock::now() - section.start).count();
}

double Timing::seconds(const std::string &name) const
{
  const auto found = sections.find(name);
  return found == sections.end() ? 0. : found->second.seconds;
}

double Timing::total() const
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}
} // namespace pellicle
