# The libraries Glare stands on, each found in the way that works on Debian 12 and Ubuntu 24.04
# as well as on newer releases.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

# Debian ships no CMake config for single-precision FFTW, and no .pc file for its variants.
pkg_check_modules(FFTW3F REQUIRED IMPORTED_TARGET fftw3f)
find_package(TBB CONFIG REQUIRED)

find_package(Imath CONFIG REQUIRED)
find_package(OpenEXR CONFIG REQUIRED)
pkg_check_modules(OCIO REQUIRED IMPORTED_TARGET OpenColorIO)
pkg_check_modules(CRYPTO REQUIRED IMPORTED_TARGET libcrypto)

find_package(OpenImageIO CONFIG REQUIRED)
# Debian's OpenImageIO config names include folders of packages that need not be installed;
# CMake stops at a missing one.
foreach(target OpenImageIO::OpenImageIO OpenImageIO::OpenImageIO_Util)
  if(TARGET ${target})
    get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
    if(folders)
      set(present "")
      foreach(folder IN LISTS folders)
        if(folder MATCHES "^\\$<" OR EXISTS "${folder}")
          list(APPEND present "${folder}")
        endif()
      endforeach()
      set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${present}")
    endif()
  endif()
endforeach()

if(GLARE_BUILD_TOOLS)
  find_package(CLI11 CONFIG REQUIRED)
  find_package(nlohmann_json CONFIG REQUIRED)
endif()
if(GLARE_BUILD_TESTS)
  find_package(GTest CONFIG REQUIRED)
  include(GoogleTest)
endif()
if(GLARE_BUILD_BENCHMARKS)
  find_package(benchmark CONFIG REQUIRED)
endif()
