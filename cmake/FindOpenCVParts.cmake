# Finds the parts of OpenCV 4 that Glare uses (core, imgproc, photo): OpenCVParts::OpenCVParts, by
# OpenCV's own CMake config where there is one, else by its files. (Debian's libopencv-core-dev,
# -imgproc-dev and -photo-dev bring neither a config nor a .pc file; these are in libopencv-dev,
# which brings half a gigabyte more.)
find_package(OpenCV 4 CONFIG QUIET COMPONENTS core imgproc photo)
if(OpenCV_FOUND)
  set(OpenCVParts_INCLUDE_DIR ${OpenCV_INCLUDE_DIRS})
  set(opencv_parts_libraries opencv_core opencv_imgproc opencv_photo)
  set(OpenCVParts_core_LIBRARY opencv_core)
else()
  find_path(OpenCVParts_INCLUDE_DIR opencv2/photo.hpp PATH_SUFFIXES opencv4)
  set(opencv_parts_libraries "")
  foreach(part photo imgproc core)
    find_library(OpenCVParts_${part}_LIBRARY opencv_${part})
    list(APPEND opencv_parts_libraries "${OpenCVParts_${part}_LIBRARY}")
    mark_as_advanced(OpenCVParts_${part}_LIBRARY)
  endforeach()
  mark_as_advanced(OpenCVParts_INCLUDE_DIR)
endif()

include(FindPackageHandleStandardArgs)
if(OpenCV_FOUND)
  find_package_handle_standard_args(OpenCVParts REQUIRED_VARS OpenCVParts_INCLUDE_DIR)
else()
  find_package_handle_standard_args(
    OpenCVParts REQUIRED_VARS OpenCVParts_INCLUDE_DIR OpenCVParts_core_LIBRARY
                              OpenCVParts_imgproc_LIBRARY OpenCVParts_photo_LIBRARY)
endif()

if(OpenCVParts_FOUND AND NOT TARGET OpenCVParts::OpenCVParts)
  add_library(OpenCVParts::OpenCVParts INTERFACE IMPORTED)
  set_target_properties(OpenCVParts::OpenCVParts PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${OpenCVParts_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${opencv_parts_libraries}")
endif()
