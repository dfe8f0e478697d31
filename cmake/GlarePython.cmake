# Finds what the Python module is built with: Python's headers, numpy and pybind11. glare_no_python
# becomes what is in the way of it, or empty.
#
# Debian's own Python comes first: a python3 earlier on PATH may be one without Debian's modules.
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that the module is for")
endif()
find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module NumPy)
if(Python_Development.Module_FOUND)
  find_package(pybind11 2.10 CONFIG QUIET)
endif()

set(glare_no_python "")
if(NOT GLARE_BUILD_TOOLS)
  set(glare_no_python "its options are the program's (GLARE_BUILD_TOOLS)")
elseif(NOT BUILD_SHARED_LIBS)
  set(glare_no_python "it stands on the shared libraries (BUILD_SHARED_LIBS)")
elseif(GLARE_SANITIZE)
  set(glare_no_python "a sanitized library needs a sanitized program around it")
elseif(NOT Python_Interpreter_FOUND OR NOT Python_Development.Module_FOUND)
  set(glare_no_python "Python's headers were not found (python3-dev)")
elseif(NOT Python_NumPy_FOUND)
  set(glare_no_python "numpy was not found (python3-numpy)")
elseif(NOT pybind11_FOUND)
  set(glare_no_python "pybind11 2.10 was not found (pybind11-dev)")
endif()
