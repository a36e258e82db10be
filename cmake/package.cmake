# These files find the installed libraries: for CMake with the targets microslip::core, microslip::scene and
# microslip::c, and for pkg-config with the target of C. All can be moved together.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/microslip)
foreach(component core c)
  install(EXPORT microslip-${component} NAMESPACE microslip:: FILE microslip-${component}.cmake
          DESTINATION ${package_folder})
endforeach()
configure_package_config_file(cmake/microslip-config.cmake.in package/microslip-config.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/microslip-config-version.cmake
  COMPATIBILITY SameMajorVersion)  # of C; C++ is not promised to stay (docs/stability.md)
install(FILES cmake/FindFFTW3.cmake
              ${PROJECT_BINARY_DIR}/package/microslip-config.cmake
              ${PROJECT_BINARY_DIR}/package/microslip-config-version.cmake
        DESTINATION ${package_folder})

file(RELATIVE_PATH prefix_from_pc /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(cmake/microslip.pc.in package/microslip.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/microslip.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/microslip
        PATTERN CMakeLists.txt EXCLUDE PATTERN __pycache__ EXCLUDE)
