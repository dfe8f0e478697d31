# What this build needs.
include(GlareLibraries)
glare_find_libraries(missing core io)
if(missing)
  list(JOIN missing "\n  " missing)
  message(FATAL_ERROR "Libraries that Glare needs were not found (Debian and Ubuntu packages in "
                      "brackets):\n  ${missing}\nInstall them, or name their folders in "
                      "CMAKE_PREFIX_PATH and PKG_CONFIG_PATH.")
endif()

if(GLARE_BUILD_TOOLS)
  find_package(CLI11 CONFIG REQUIRED)
  find_package(nlohmann_json CONFIG REQUIRED)
  find_package(tomlplusplus CONFIG REQUIRED)
endif()
if(GLARE_BUILD_BENCHMARKS)
  if(NOT GLARE_BUILD_TOOLS)
    message(FATAL_ERROR "GLARE_BUILD_BENCHMARKS needs GLARE_BUILD_TOOLS: they time the program too.")
  endif()
  find_package(benchmark CONFIG REQUIRED)
endif()
if(GLARE_BUILD_TESTS)
  find_package(GTest CONFIG REQUIRED)
endif()
