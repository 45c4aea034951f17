# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs the build into a scratch prefix, moves that prefix, copies doc/examples/custom_app out of the tree, then builds and runs the copy.
# Variables: BINARY_DIR, SOURCE_DIR, CONFIG, CXX_COMPILER.

set(scratch ${BINARY_DIR}/tests/custom_app_scratch)
set(prefix ${scratch}/moved)
file(REMOVE_RECURSE ${scratch})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${scratch}/installed --config ${CONFIG})
file(RENAME ${scratch}/installed ${prefix})

# Nothing in the package may lead back to where it was built.
file(GLOB_RECURSE package_files ${prefix}/*.cmake)
if(NOT package_files)
  message(FATAL_ERROR "The installation has no CMake package.")
endif()
foreach(file IN LISTS package_files)
  file(READ ${file} content)
  foreach(path IN ITEMS ${SOURCE_DIR} ${BINARY_DIR} ${scratch} pellicle_settings)
    string(FIND "${content}" "${path}" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${file} refers to the build tree: ${path}")
    endif()
  endforeach()
endforeach()
foreach(needed IN ITEMS share/pellicle/prm share/pellicle/render)
  if(NOT EXISTS ${prefix}/${needed})
    message(FATAL_ERROR "The installation lacks ${needed}.")
  endif()
endforeach()

file(COPY ${SOURCE_DIR}/doc/examples/custom_app DESTINATION ${scratch})
run(${CMAKE_COMMAND} -G Ninja -S ${scratch}/custom_app -B ${scratch}/build -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=${CONFIG}
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER})
run(${CMAKE_COMMAND} --build ${scratch}/build --config ${CONFIG})
run(${CMAKE_CTEST_COMMAND} --test-dir ${scratch}/build --output-on-failure --no-tests=error)
file(REMOVE_RECURSE ${scratch})
