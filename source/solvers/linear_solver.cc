// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/base/near_match.h>
#include <pellicle/solvers/linear_solver.h>

#include "direct_solvers.h"

#include <mpi.h>

namespace pellicle
{
namespace
{
int n_mpi_processes()
{
  int initialised = 0, n = 1;
  MPI_Initialized(&initialised);
  if (initialised)
    MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}
} // namespace

const std::vector<std::string> &linear_solver_names()
{
  static const std::vector<std::string> names{"mumps", "umfpack"};
  return names;
}

std::unique_ptr<LinearSolver> make_linear_solver(const std::string &name)
{
  if (name == "mumps")
    return internal::make_mumps_solver();
  if (name == "umfpack")
  {
    if (const int n = n_mpi_processes(); n > 1)
      throw UserError("Linear solver 'umfpack' works with one MPI process, this run has " + std::to_string(n) +
                      ". Use 'mumps', or start without mpirun.");
    return internal::make_umfpack_solver();
  }
  throw UserError("There is no linear solver '" + name + "'." + suggestion(name, linear_solver_names()));
}
} // namespace pellicle
