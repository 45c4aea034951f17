// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace pellicle
{
/**
 * The processes of a run. Mesh, state and vectors are replicated; cells and factorisation are distributed (contract 9).
 * Without MPI (not initialised) there is one process and sums cost nothing.
 */
class Communicator
{
public:
  Communicator();

  int rank() const { return my_rank; }
  int size() const { return n_processes; }

  /** First and one-past-last cell of this process. */
  std::pair<std::size_t, std::size_t> own_range(std::size_t n) const;

  /** Replaces the values by their sum over the processes, the same on each of them. */
  void sum(std::vector<double> &values) const;
  /** The largest of the processes' values. */
  double largest(double value) const;

private:
  int my_rank     = 0;
  int n_processes = 1;
};
} // namespace pellicle
