# SPDX-License-Identifier: LGPL-2.1-or-later
# What is installed besides the applications (PellicleApplication.cmake): headers, the two libraries as targets Pellicle::point and
# Pellicle::pellicle, the package for find_package(Pellicle), the scenes that ship, and the renderer of pictures.

include(CMakePackageConfigHelpers)
set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/Pellicle)

install(DIRECTORY include/pellicle DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(TARGETS pellicle_point pellicle EXPORT PellicleTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})

# The target is called pellicle_point in the build; users of the build tree and of the package write the same names.
add_library(Pellicle::point ALIAS pellicle_point)
add_library(Pellicle::pellicle ALIAS pellicle)

install(EXPORT PellicleTargets NAMESPACE Pellicle:: DESTINATION ${package_directory})
configure_package_config_file(contrib/cmake/PellicleConfig.cmake.in ${PROJECT_BINARY_DIR}/PellicleConfig.cmake
                              INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/PellicleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/PellicleConfig.cmake ${PROJECT_BINARY_DIR}/PellicleConfigVersion.cmake
              contrib/cmake/PellicleDependencies.cmake DESTINATION ${package_directory})

install(DIRECTORY prm DESTINATION ${CMAKE_INSTALL_DATADIR}/pellicle)
install(DIRECTORY contrib/render DESTINATION ${CMAKE_INSTALL_DATADIR}/pellicle USE_SOURCE_PERMISSIONS
        PATTERN __pycache__ EXCLUDE)
