// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace pellicle
{
/**
 * Wall-clock seconds of named sections, added up over all visits, and of everything since construction. Construct it
 * first in main. For one thread.
 */
class Timing
{
  using Clock = std::chrono::steady_clock;

  struct Section
  {
    double seconds = 0.;     ///< of completed visits
    int depth      = 0;      ///< visits that are open; only the outermost counts
    Clock::time_point start; ///< of the outermost open visit
  };

public:
  /** One visit of a section: from its construction to its destruction. May be nested, also within the same section. */
  class Scope
  {
  public:
    Scope(Timing &timing, const std::string &name);
    ~Scope();
    Scope(const Scope &)            = delete;
    Scope &operator=(const Scope &) = delete;

  private:
    Section &section;
  };

  /** Seconds of the completed visits of a section; 0 for one that was never visited. */
  double seconds(const std::string &name) const;
  /** Seconds since construction. */
  double total() const;

private:
  Clock::time_point start = Clock::now();
  std::map<std::string, Section> sections; // scopes hold references to elements, which a map keeps in place
};
} // namespace pellicle
