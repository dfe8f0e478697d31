// Pictures of the built-in eye, from options in the words of the command line.

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "aperture/aperture_outputs.h"
#include "aperture/eye_arguments.h"
#include "bindings.h"
#include "command_words.h"
#include "glare/base/error.h"
#include "interruptible.h"

namespace glare::python {

namespace py = pybind11;

namespace {

struct EyePictureArguments {
  tool::EyeArguments eye;
  std::optional<double> age_years;
  tool::DrawingArguments drawing;
};

void add_eye_picture_options(CLI::App& command, EyePictureArguments& a) {
  tool::add_drawing_options(command, a.drawing);
  command.add_option("--age", a.age_years);
  tool::add_eye_model_options(command, a.eye);
}

EyeView view_from(const std::string& name) {
  if (name == "whole") return EyeView::whole;
  if (name == "pupil") return EyeView::pupil;
  if (name == "eyelashes") return EyeView::eyelashes;
  throw OptionError("view '" + name + "': expected whole, pupil or eyelashes");
}

/// ((h, w) transmittance, width_mm).
py::tuple eye_picture(const Words& words, const std::string& view, const py::object& progress) {
  EyePictureArguments a;
  CLI::App command;
  add_eye_picture_options(command, a);
  parse(command, words);
  const EyeView what = view_from(view);
  const EyeParameters eye = tool::eye_parameters(a.eye, a.age_years);
  const double pixel = tool::pixel_mm(a.drawing, eye_picture_width_mm(eye));
  Aperture drawn;
  run_released(progress, [&](const ProgressCallback& note) {
    drawn = draw_eye(eye, pixel, a.drawing.threads, note, what);
  });
  const Image<float>& t = drawn.transmittance;
  py::array_t<float> array(std::vector<py::ssize_t>{t.height(), t.width()});
  std::copy(t.values().begin(), t.values().end(), array.mutable_data());
  return py::make_tuple(array, drawn.width_mm);
}

std::map<std::string, int> eye_picture_options_by_name() {
  EyePictureArguments arguments;
  CLI::App command;
  add_eye_picture_options(command, arguments);
  return options_of(command);
}

}  // namespace

void add_eye_picture(py::module_& module) {
  module.def("eye_picture_options", &eye_picture_options_by_name);
  module.def("eye_picture", &eye_picture, py::arg("words"), py::arg("view"), py::arg("progress"));
}

}  // namespace glare::python
