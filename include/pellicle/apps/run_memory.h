// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/archive.h>

#include <functional>

namespace pellicle
{
/** Writes to an archive, or reads from it, all that a run needs to be taken up again after a step. */
using RunState = std::function<void(Archive &archive)>;

/** What becomes of a run's state: here nothing. All processes call it alike. */
class RunMemory
{
public:
  virtual ~RunMemory() = default;

  /** The run begins: gives it the state of an earlier one to read. False: there is none, it begins at its beginning. */
  virtual bool take_up(const RunState & /*state*/) { return false; }
  /** A step is done, and is in the files. */
  virtual void after_step(const RunState & /*state*/) {}
};
} // namespace pellicle
