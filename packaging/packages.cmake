# What `cmake --install` and CPack put where: the program with its scenes, pages, manual page and completion; the
# library with its headers; the Python package.
include(CMakePackageConfigHelpers)

# A wheel takes the parts that python/CMakeLists.txt names, and none of these.
if(NOT SKBUILD)
  install(TARGETS nilas RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
# nilas verify finds its scenes beside the program.
install(DIRECTORY apps/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/nilas)
# The page that links to the others, and these beside it.
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
        PATTERN "*.py" EXCLUDE PATTERN "docs/site" EXCLUDE PATTERN "docs/figures/data" EXCLUDE
        PATTERN "docs/figures/README.md" EXCLUDE)

# The program prints its own manual page and its completion.
set(man ${CMAKE_CURRENT_BINARY_DIR}/nilas.1)
set(completion ${CMAKE_CURRENT_BINARY_DIR}/nilas.bash)
add_custom_command(OUTPUT ${man}.gz ${completion}
  COMMAND nilas schema --man > ${man}
  COMMAND gzip -9nf ${man}
  COMMAND nilas schema --completion > ${completion}
  DEPENDS nilas VERBATIM)
add_custom_target(shell_files ALL DEPENDS ${man}.gz ${completion})
install(FILES ${man}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${completion} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME nilas)

# The library: its headers without those of its own sources, and what find_package(nilas) reads.
if(NOT SKBUILD)
  install(TARGETS libnilas EXPORT nilas LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set(config ${CMAKE_INSTALL_LIBDIR}/cmake/nilas)
  install(EXPORT nilas FILE nilasConfig.cmake NAMESPACE nilas:: DESTINATION ${config})
  write_basic_package_version_file(nilasConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/nilasConfigVersion.cmake DESTINATION ${config})
endif()
install(DIRECTORY nilas DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h"
        PATTERN "*_content.h" EXCLUDE PATTERN "translate.h" EXCLUDE PATTERN "applied_loads.h" EXCLUDE)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME nilas)
set(CPACK_PACKAGE_VENDOR "The Nilas developers")
set(CPACK_PACKAGE_CONTACT "The Nilas developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The package for Python works with the one version that it was built for.
if(NILAS_PYTHON)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
      "python3 (>= ${NILAS_PYTHON_VERSION}~), python3 (<< ${NILAS_NEXT_PYTHON_VERSION}~), python3-numpy")
endif()
# It removes what Python compiled there.
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/packaging/prerm)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, python3-h5py, python3-pandas, python3-yaml, python3-scipy, python3-matplotlib, python3-jinja2")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "chromium, ffmpeg, python3-xarray")
include(CPack)
