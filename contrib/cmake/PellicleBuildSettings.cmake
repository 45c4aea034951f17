# SPDX-License-Identifier: LGPL-2.1-or-later
# Language standard, warnings, sanitizers and the compiler cache.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)
endif()
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

option(PELLICLE_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
option(PELLICLE_SANITIZE "Address and undefined-behaviour sanitizers" OFF)
option(PELLICLE_FUZZERS "Fuzzers (libFuzzer, needs Clang)" OFF)

add_library(pellicle_settings INTERFACE)
target_compile_options(pellicle_settings INTERFACE -Wall -Wextra -Wpedantic $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local> -Wnon-virtual-dtor
                                                   $<$<BOOL:${PELLICLE_WARNINGS_AS_ERRORS}>:-Werror>)
# -O3 and no errno for the point kernels; strict IEEE arithmetic otherwise (nan and inf are part of the user interface).
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG -fno-math-errno")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g")
if(PELLICLE_SANITIZE)
  set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1") # lines for the reports, no variables: half the size
  target_compile_options(pellicle_settings INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(pellicle_settings INTERFACE -fsanitize=address,undefined LINKER:--export-dynamic-symbol=dlclose)
  target_sources(pellicle_settings INTERFACE
                 $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:${PROJECT_SOURCE_DIR}/contrib/utilities/keep_loaded.cc>)
endif()
if(PELLICLE_FUZZERS)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "PELLICLE_FUZZERS needs Clang, not ${CMAKE_CXX_COMPILER_ID}: configure with 'cmake --preset sanitize'")
  endif()
  # Everything counts which branches it takes; only the fuzzers themselves are linked with the driver (tests/fuzz).
  target_compile_options(pellicle_settings INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(pellicle_settings INTERFACE -fsanitize=fuzzer-no-link)
endif()

# Precompiled headers defeat ccache unless it is told not to worry about time stamps and defines inside them.
find_program(PELLICLE_CCACHE ccache)
if(PELLICLE_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
                                  ${PELLICLE_CCACHE})
endif()
