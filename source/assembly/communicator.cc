// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/communicator.h>

#include <mpi.h>

namespace pellicle
{
Communicator::Communicator()
{
  int initialized = 0, finalized = 0;
  MPI_Initialized(&initialized);
  MPI_Finalized(&finalized);
  if (initialized != 0 && finalized == 0)
  {
    MPI_Comm_rank(MPI_COMM_WORLD, &my_rank);
    MPI_Comm_size(MPI_COMM_WORLD, &n_processes);
  }
}

std::pair<std::size_t, std::size_t> Communicator::own_range(const std::size_t n) const
{
  return {n * my_rank / n_processes, n * (my_rank + 1) / n_processes};
}

void Communicator::sum(std::vector<double> &values) const
{
  if (n_processes > 1)
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

double Communicator::largest(double value) const
{
  if (n_processes > 1)
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return value;
}
} // namespace pellicle
