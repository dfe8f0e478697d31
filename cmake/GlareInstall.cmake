# `cmake --install`: the libraries and their headers, glare_io's modules, the program, a package for
# find_package(glare CONFIG) with the components core, io and c, and one for pkg-config. Nothing in it
# holds the prefix: the installed tree can be moved.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/glare)
set(package_build_dir ${PROJECT_BINARY_DIR}/package)

# One export a component, so that core can be used where io's libraries are missing.
foreach(component core io c)
  install(TARGETS glare_${component} EXPORT glare-${component}-targets
          RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT glare-${component}-targets NAMESPACE glare:: DESTINATION ${package_dir})
endforeach()
# The modules: in a folder of this version beside libglare_io, as src/glare/CMakeLists.txt has it.
if(BUILD_SHARED_LIBS)
  set(module_folder glare-${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  install(TARGETS glare_image_codec glare_color_config glare_eye_photo
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/${module_folder})
endif()
if(GLARE_BUILD_TOOLS)
  install(TARGETS glare RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

configure_package_config_file(cmake/glareConfig.cmake.in ${package_build_dir}/glareConfig.cmake
                              INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${package_build_dir}/glareConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${package_build_dir}/glareConfig.cmake ${package_build_dir}/glareConfigVersion.cmake
              cmake/GlareLibraries.cmake cmake/FindOpenCVParts.cmake
        DESTINATION ${package_dir})

# Static libraries leave it to the program to link what they stand on.
if(BUILD_SHARED_LIBS)
  set(pc_core_requires "")
  set(pc_io_requires "")
  set(pc_c_requires "Requires.private")
  set(pc_c_libs "")
else()
  set(pc_core_requires "fftw3f tbb libhwy")
  set(pc_io_requires "OpenImageIO OpenEXR Imath OpenColorIO libcrypto zlib")
  set(pc_c_requires "Requires")
  set(pc_c_libs " -lstdc++")
endif()
file(RELATIVE_PATH pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" pc_prefix "${pc_prefix}")
foreach(name glare-core glare glare-c)
  configure_file(cmake/${name}.pc.in ${package_build_dir}/${name}.pc @ONLY)
  install(FILES ${package_build_dir}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)

# The beams of data/photometry, for `glare photometry` and `glare headlamp`.
install(DIRECTORY data/photometry DESTINATION ${CMAKE_INSTALL_DATADIR}/glare
        FILES_MATCHING PATTERN "*.ies" PATTERN "README.md")
