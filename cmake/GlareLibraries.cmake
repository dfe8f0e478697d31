# glare_find_libraries(OUT_MISSING COMPONENT...): finds the libraries that Glare's components (core,
# io) stand on, each in the way that works on Debian 12 and Ubuntu 24.04 as well as on newer
# releases. OUT_MISSING becomes the list of those that aren't there, each with its Debian package.
# Used by Glare's own build and, where Glare was built as static libraries, by its package config.
function(glare_find_libraries out_missing)
  list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_FUNCTION_LIST_DIR})  # FindOpenCVParts.cmake
  set(missing "")
  find_package(PkgConfig QUIET)
  if(NOT PkgConfig_FOUND)
    set(${out_missing} "pkg-config (pkg-config)" PARENT_SCOPE)
    return()
  endif()

  if(core IN_LIST ARGN)
    find_package(Threads QUIET)
    # Debian ships no CMake config for single-precision FFTW.
    pkg_check_modules(FFTW3F QUIET IMPORTED_TARGET fftw3f)
    find_package(TBB CONFIG QUIET)
    find_package(hwy CONFIG QUIET)
    foreach(library "Threads::Threads|POSIX threads (libc6-dev)"
                    "PkgConfig::FFTW3F|FFTW 3, single precision (libfftw3-dev)"
                    "TBB::tbb|oneTBB (libtbb-dev)"
                    "hwy::hwy|Highway (libhwy-dev)")
      glare_note_missing(missing "${library}")
    endforeach()
  endif()

  if(io IN_LIST ARGN)
    find_package(Imath CONFIG QUIET)
    find_package(OpenEXR CONFIG QUIET)
    # OpenColorIO's CMake config on Debian names an include folder that isn't there.
    pkg_check_modules(OCIO QUIET IMPORTED_TARGET OpenColorIO)
    pkg_check_modules(CRYPTO QUIET IMPORTED_TARGET libcrypto)
    find_package(ZLIB QUIET)
    find_package(OpenImageIO CONFIG QUIET)
    glare_drop_missing_include_folders(OpenImageIO::OpenImageIO OpenImageIO::OpenImageIO_Util)
    find_package(OpenCVParts MODULE QUIET)
    foreach(library "Imath::Imath|Imath 3 (libimath-dev)"
                    "OpenEXR::OpenEXR|OpenEXR 3 (libopenexr-dev)"
                    "PkgConfig::OCIO|OpenColorIO 2 (libopencolorio-dev)"
                    "PkgConfig::CRYPTO|OpenSSL's libcrypto (libssl-dev)"
                    "ZLIB::ZLIB|zlib (zlib1g-dev)"
                    "OpenImageIO::OpenImageIO|OpenImageIO 2.4 (libopenimageio-dev, openimageio-tools)"
                    "OpenCVParts::OpenCVParts|OpenCV 4: core, imgproc, photo (libopencv-core-dev, libopencv-imgproc-dev, libopencv-photo-dev)")
      glare_note_missing(missing "${library}")
    endforeach()
  endif()
  set(${out_missing} "${missing}" PARENT_SCOPE)
endfunction()

# Appends NAME to the list LIST where "TARGET|NAME" names a target that isn't there.
function(glare_note_missing list target_and_name)
  string(REPLACE "|" ";" parts "${target_and_name}")
  list(POP_FRONT parts target)
  if(NOT TARGET ${target})
    set(${list} ${${list}} "${parts}" PARENT_SCOPE)
  endif()
endfunction()

# Debian's OpenImageIO config names include folders of packages that need not be installed; CMake
# stops at a missing one.
function(glare_drop_missing_include_folders)
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
      set(present "")
      foreach(folder IN LISTS folders)
        if(folder MATCHES "^\\$<" OR EXISTS "${folder}")
          list(APPEND present "${folder}")
        endif()
      endforeach()
      set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${present}")
    endif()
  endforeach()
endfunction()
