// The extension module _glare: the package glare's way to the library. Lamps, observers and the
// CIE's glare are here.

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <span>
#include <string>

#include "bindings.h"
#include "glare/base/error.h"
#include "glare/io/lamp_file.h"
#include "glare/scatter/straylight.h"
#include "glare/spectrum/lamps.h"
#include "glare/spectrum/observer.h"

namespace glare::python {

namespace py = pybind11;

namespace {

py::array_t<double> array_of(std::span<const double> values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::list lamps() {
  py::list result;
  for (const BuiltInLamp& lamp : built_in_lamps())
    result.append(py::make_tuple(lamp.name, lamp.alias, lamp.description));
  return result;
}

py::tuple spectrum(const std::string& name) {
  const NamedLamp lamp = lamp_from(name);
  return py::make_tuple(array_of(lamp.spectrum.wavelengths_nm()), array_of(lamp.spectrum.values()));
}

py::tuple observer(const std::string& name) {
  const ColorMatchingFunctions& functions = color_matching_functions(name);
  return py::make_tuple(array_of(functions.y_bar.wavelengths_nm()),
                        array_of(functions.x_bar.values()), array_of(functions.y_bar.values()),
                        array_of(functions.z_bar.values()));
}

}  // namespace

void add_tables(py::module_& module) {
  module.def("lamps", &lamps);
  module.def("spectrum", &spectrum, py::arg("name"));
  module.def("observer", &observer, py::arg("name"));
  module.def("cie_glare", py::vectorize(&cie_general_glare), py::arg("angle_deg"), py::arg("age"),
             py::arg("pigment"));
}

}  // namespace glare::python

PYBIND11_MODULE(_glare, module) {
  namespace py = pybind11;
  module.attr("__version__") = GLARE_VERSION;
  glare::python::add_errors(module);
  glare::python::add_tables(module);
  glare::python::add_template(module);
  glare::python::add_template_making(module);
  glare::python::add_eye_picture(module);
  glare::python::add_filter(module);
}
