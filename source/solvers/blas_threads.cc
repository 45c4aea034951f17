// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/solvers/linear_solver.h>

#include <dlfcn.h>

namespace pellicle
{
bool set_blas_threads(const int n)
{
  // Looked up at run time: any BLAS may be active, and only OpenBLAS has this call.
  using Setter = void (*)(int);
  if (const auto setter = reinterpret_cast<Setter>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
  {
    setter(n);
    return true;
  }
  return false;
}
} // namespace pellicle
