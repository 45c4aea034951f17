# SPDX-License-Identifier: LGPL-2.1-or-later
# Imported targets for what Pellicle stands on. Included by the build and by the installed package, so that both see the same.

include(CMakeFindDependencyMacro)

# find_dependency() takes from the surrounding find_package() whether a missing library is an error. In the build itself it always is.
if(NOT CMAKE_FIND_PACKAGE_NAME)
  set(CMAKE_FIND_PACKAGE_NAME Pellicle)
  set(Pellicle_FIND_REQUIRED TRUE)
  set(Pellicle_BUILD_TYPE ${CMAKE_BUILD_TYPE})
endif()

# --- deal.II: only its library and include directories are taken; its compiler flags are not imposed on users.
find_dependency(deal.II 9.4.1)
find_dependency(MPI COMPONENTS C)
if(NOT TARGET pellicle_dealii)
  add_library(pellicle_dealii INTERFACE IMPORTED)
  set_target_properties(pellicle_dealii PROPERTIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${DEAL_II_INCLUDE_DIRS}")
  set_property(TARGET pellicle_dealii PROPERTY INTERFACE_INCLUDE_DIRECTORIES "${DEAL_II_INCLUDE_DIRS}")
  # deal.II lists all of its own dependencies; the first entry is deal.II itself and is all that our code refers to.
  if(Pellicle_BUILD_TYPE STREQUAL "Debug")
    list(GET DEAL_II_LIBRARIES_DEBUG 0 _dealii_library)
    set_property(TARGET pellicle_dealii PROPERTY INTERFACE_COMPILE_DEFINITIONS DEBUG)
  else()
    list(GET DEAL_II_LIBRARIES_RELEASE 0 _dealii_library)
  endif()
  find_library(PELLICLE_TBB tbb REQUIRED)
  # Inline functions of deal.II's headers refer to libraries (Teuchos, the MPI C++ bindings) that only deal.II itself names as needed.
  set_property(TARGET pellicle_dealii PROPERTY INTERFACE_LINK_OPTIONS "LINKER:--copy-dt-needed-entries")
  set_property(TARGET pellicle_dealii PROPERTY INTERFACE_LINK_LIBRARIES "${_dealii_library};MPI::MPI_C;${PELLICLE_TBB}")
endif()

# --- Direct solvers, each through its own C interface.
find_path(PELLICLE_MUMPS_INCLUDE dmumps_c.h REQUIRED)
find_library(PELLICLE_MUMPS dmumps REQUIRED)
find_path(PELLICLE_UMFPACK_INCLUDE umfpack.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(PELLICLE_UMFPACK umfpack REQUIRED)
find_package(BLAS QUIET)
find_library(PELLICLE_BLAS blas REQUIRED)
if(NOT TARGET pellicle_direct_solvers)
  add_library(pellicle_direct_solvers INTERFACE IMPORTED)
  set_property(TARGET pellicle_direct_solvers PROPERTY INTERFACE_INCLUDE_DIRECTORIES "${PELLICLE_MUMPS_INCLUDE};${PELLICLE_UMFPACK_INCLUDE}")
  set_property(TARGET pellicle_direct_solvers
               PROPERTY INTERFACE_LINK_LIBRARIES "${PELLICLE_MUMPS};${PELLICLE_UMFPACK};${PELLICLE_BLAS};MPI::MPI_C;${CMAKE_DL_LIBS}")
endif()

# Factorisations run 3 to 5 times faster with OpenBLAS than with the reference BLAS that Debian installs by default.
# What counts is the library that the loader finds under the soname, not the one behind the development link.
get_filename_component(_blas_directory "${PELLICLE_BLAS}" DIRECTORY)
set(_blas_file "${PELLICLE_BLAS}")
if(EXISTS "${_blas_directory}/libblas.so.3")
  set(_blas_file "${_blas_directory}/libblas.so.3")
endif()
get_filename_component(_blas_file "${_blas_file}" REALPATH)
if(NOT _blas_file MATCHES "openblas")
  message(WARNING "The active BLAS is ${_blas_file}, not OpenBLAS: factorisations will be 3 to 5 times slower. "
                  "On Debian: apt-get install libopenblas0-pthread")
endif()

# Eigenvalues. deal.II is linked with it, too, so that it costs no time at the start of a program.
find_path(PELLICLE_ARPACK_INCLUDE arpack.h PATH_SUFFIXES arpack REQUIRED)
find_library(PELLICLE_ARPACK arpack REQUIRED)
if(NOT TARGET pellicle_arpack)
  add_library(pellicle_arpack INTERFACE IMPORTED)
  set_property(TARGET pellicle_arpack PROPERTY INTERFACE_INCLUDE_DIRECTORIES "${PELLICLE_ARPACK_INCLUDE}")
  set_property(TARGET pellicle_arpack PROPERTY INTERFACE_LINK_LIBRARIES "${PELLICLE_ARPACK}")
endif()

# Integration in time. deal.II is linked with it as well.
find_path(PELLICLE_IDAS_INCLUDE idas/idas.h REQUIRED)
find_library(PELLICLE_IDAS sundials_idas REQUIRED)
find_library(PELLICLE_NVECTOR sundials_nvecserial REQUIRED)
if(NOT TARGET pellicle_idas)
  add_library(pellicle_idas INTERFACE IMPORTED)
  set_property(TARGET pellicle_idas PROPERTY INTERFACE_INCLUDE_DIRECTORIES "${PELLICLE_IDAS_INCLUDE}")
  set_property(TARGET pellicle_idas PROPERTY INTERFACE_LINK_LIBRARIES "${PELLICLE_IDAS};${PELLICLE_NVECTOR}")
endif()

find_dependency(Eigen3)
find_dependency(nlohmann_json)
find_dependency(CLI11)

# Sacado is header-only for what is used here (forward-mode types of fixed size).
find_path(PELLICLE_SACADO_INCLUDE Sacado.hpp PATH_SUFFIXES trilinos REQUIRED)
if(NOT TARGET pellicle_sacado)
  add_library(pellicle_sacado INTERFACE IMPORTED)
  set_property(TARGET pellicle_sacado PROPERTY INTERFACE_INCLUDE_DIRECTORIES "${PELLICLE_SACADO_INCLUDE}")
endif()

# Derivatives of expressions in scenes. GiNaC's headers refer to the numbers of CLN.
find_path(PELLICLE_GINAC_INCLUDE ginac/ginac.h REQUIRED)
find_library(PELLICLE_GINAC ginac REQUIRED)
find_library(PELLICLE_CLN cln REQUIRED)
if(NOT TARGET pellicle_ginac)
  add_library(pellicle_ginac INTERFACE IMPORTED)
  set_property(TARGET pellicle_ginac PROPERTY INTERFACE_INCLUDE_DIRECTORIES "${PELLICLE_GINAC_INCLUDE}")
  set_property(TARGET pellicle_ginac PROPERTY INTERFACE_LINK_LIBRARIES "${PELLICLE_GINAC};${PELLICLE_CLN}")
endif()
