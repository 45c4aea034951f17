# SPDX-License-Identifier: LGPL-2.1-or-later
# pellicle_add_application(name): the program source/apps/name.cc, built into <build>/bin and installed into <prefix>/bin.
# The target `applications` is all of them.

include_guard()
include(GNUInstallDirs)
add_custom_target(applications)

function(pellicle_add_application name)
  add_executable(${name} ${PROJECT_SOURCE_DIR}/source/apps/${name}.cc)
  target_link_libraries(${name} PRIVATE pellicle pellicle_settings)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  add_dependencies(applications ${name})
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()
