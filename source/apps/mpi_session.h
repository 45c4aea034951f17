// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace pellicle
{
/** MPI for the lifetime of a run, unless somebody initialised it before. */
class MpiSession
{
public:
  MpiSession(int &argc, char **&argv);
  ~MpiSession();
  MpiSession(const MpiSession &)            = delete;
  MpiSession &operator=(const MpiSession &) = delete;

private:
  bool own = false;
};

/**
 * True if all processes come here within a second. A bad scene stops all of them alike, and then MPI can end in an
 * orderly way; an error of one process (files are the first one's business) leaves the others waiting in a computation,
 * and only an abort ends those.
 */
bool all_processes_arrive();
} // namespace pellicle
