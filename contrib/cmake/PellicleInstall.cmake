# SPDX-License-Identifier: LGPL-2.1-or-later
# Installed headers, exported targets and the package configuration for find_package(Pellicle).

include(CMakePackageConfigHelpers)
install(DIRECTORY include/pellicle DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(TARGETS pellicle_point pellicle EXPORT PellicleTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT PellicleTargets NAMESPACE Pellicle:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Pellicle)
configure_package_config_file(contrib/cmake/PellicleConfig.cmake.in ${CMAKE_BINARY_DIR}/PellicleConfig.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Pellicle)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/PellicleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/PellicleConfig.cmake ${CMAKE_BINARY_DIR}/PellicleConfigVersion.cmake
              contrib/cmake/PellicleDependencies.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Pellicle)
install(DIRECTORY prm DESTINATION ${CMAKE_INSTALL_DATADIR}/pellicle)
