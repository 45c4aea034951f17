// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mpi_session.h"

#include <mpi.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace pellicle
{
MpiSession::MpiSession(int &argc, char **&argv)
{
  int running = 0;
  MPI_Initialized(&running);
  if (running == 0)
  {
    constexpr const char *topology_sources = "HWLOC_COMPONENTS";
    const bool has_sources                 = std::getenv(topology_sources) != nullptr;
    // Started by hand and not by mpirun, Open MPI would launch a daemon and look for networks: 0.3 s for one process
    // that talks to nobody.
    if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMIX_RANK") == nullptr &&
        std::getenv("PMI_RANK") == nullptr)
    {
      constexpr int keep_users_choice = 0;
      setenv("OMPI_MCA_ess_singleton_isolated", "1", keep_users_choice);
      // Isolated processes would all use the same session folder and take it away from under each other; one process
      // needs none.
      setenv("OMPI_MCA_orte_create_session_dirs", "0", keep_users_choice);
      setenv("OMPI_MCA_pml", "ob1", keep_users_choice);
      setenv("OMPI_MCA_btl", "self", keep_users_choice);
      // Nor need it know the machine: looking at its buses and caches takes as long as the rest.
      setenv(topology_sources, "no_os,stop", keep_users_choice);
    }
    MPI_Init(&argc, &argv);
    if (!has_sources)
      unsetenv(topology_sources); // programs that this one starts know nothing of it
    own = true;
  }
}

MpiSession::~MpiSession()
{
  if (own)
    MPI_Finalize();
}

bool all_processes_arrive()
{
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  int arrived = 0;
  for (int waits = 0; arrived == 0 && waits < 100; ++waits)
  {
    MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
    if (arrived == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return arrived != 0;
}
} // namespace pellicle
