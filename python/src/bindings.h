// The parts of the extension module _glare.
#pragma once

#include <pybind11/pybind11.h>

namespace glare::python {

/// The exceptions of `base/error.h`, as Python's.
void add_errors(pybind11::module_& module);

/// Lamps, observers, the CIE's glare: numbers only.
void add_tables(pybind11::module_& module);

/// The class Template, and what makes and reads one.
void add_template(pybind11::module_& module);
void add_template_making(pybind11::module_& module);

/// The built-in eye's pictures.
void add_eye_picture(pybind11::module_& module);

/// Filters and points: what adds glare to pictures.
void add_filter(pybind11::module_& module);

}  // namespace glare::python
