// Templates from options, in the words of the command line.

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bindings.h"
#include "command_words.h"
#include "glare/base/error.h"
#include "glare/io/aperture_file.h"
#include "glare/io/lamp_file.h"
#include "glare/io/sha256.h"
#include "interruptible.h"
#include "template/template_arguments.h"
#include "template/template_notes.h"
#include "template/template_optics.h"
#include "template/template_recipe.h"
#include "template_object.h"

namespace glare::python {

namespace py = pybind11;

namespace {

using FloatArray = py::array_t<float, py::array::c_style | py::array::forcecast>;
using DoubleArray = py::array_t<double, py::array::c_style | py::array::forcecast>;
/// A name or file, or wavelengths in nm with the power there.
using LampArgument = std::variant<std::string, std::pair<DoubleArray, DoubleArray>>;

/// An array instead of a picture file, under the name that the recipe has for it.
struct ArrayInput {
  std::string name;
  Aperture aperture;
};

std::optional<ArrayInput> array_input(const std::optional<FloatArray>& array) {
  constexpr py::ssize_t kLargest = 65535;
  if (!array) return std::nullopt;
  if (array->ndim() != 2 || array->shape(0) > kLargest || array->shape(1) > kLargest)
    throw InputError("", "an aperture's array must be (h, w), of at most 65535 each");
  const int height = static_cast<int>(array->shape(0)), width = static_cast<int>(array->shape(1));
  Aperture aperture{Image<float>::uninitialized(width, height), 0};
  std::copy(array->data(), array->data() + array->size(), aperture.transmittance.values().begin());
  return ArrayInput{"array:" + std::to_string(width) + "x" + std::to_string(height) + ":float32",
                    std::move(aperture)};
}

template <typename Range>
std::string fingerprint_of(const Range& values) {
  return sha256_of(std::as_bytes(std::span(values)));
}

/// Everything that one call makes templates from.
struct Request {
  tool::TemplateArguments arguments;
  std::optional<ArrayInput> pupil, eyelashes;
  std::vector<NamedLamp> lamps;
  tool::RecipeWriter::Fingerprints fingerprints;
  Words warnings;
};

NamedLamp lamp_of(const LampArgument& argument, Request& request) {
  if (const auto* const name = std::get_if<std::string>(&argument)) return lamp_from(*name);
  const auto& [wavelengths, power] = std::get<std::pair<DoubleArray, DoubleArray>>(argument);
  if (wavelengths.ndim() != 1 || power.ndim() != 1)
    throw InputError("lamp", "expected two one-dimensional arrays, wavelength in nm and power");
  const auto copy = [](const DoubleArray& a) {
    return std::vector<double>(a.data(), a.data() + a.size());
  };
  std::vector<double> both = copy(wavelengths);
  const std::vector<double> values = copy(power);
  Spectrum spectrum(both, values);
  both.insert(both.end(), values.begin(), values.end());
  const std::string fingerprint = fingerprint_of(both);
  NamedLamp lamp{"array:" + fingerprint.substr(0, 8) + ":float64", {}, std::move(spectrum)};
  lamp.file = lamp.name;
  request.fingerprints[lamp.file] = fingerprint;
  return lamp;
}

void use_array(std::optional<ArrayInput>& input, std::string& argument, const char* option,
               Request& request) {
  if (!input) return;
  if (!request.arguments.width_mm)
    throw OptionError("--width-mm is missing: the physical width of the aperture's arrays");
  if (!(*request.arguments.width_mm >= 1e-3 && *request.arguments.width_mm <= 1e6))
    throw OptionError("the aperture's width must be from 0.001 to 1000000 mm");
  input->aperture.width_mm = *request.arguments.width_mm;
  try {
    require_valid(input->aperture);
  } catch (const InputError& error) {
    throw InputError(option, error.message());
  }
  argument = std::string(option) + "-" + input->name;
  request.fingerprints[argument] = fingerprint_of(input->aperture.transmittance.values());
}

Request request_of(const Words& words, const std::optional<FloatArray>& pupil,
                   const std::optional<FloatArray>& eyelashes,
                   const std::vector<LampArgument>& lamps) {
  Request request;
  CLI::App command;
  tool::add_template_options(command, request.arguments);
  Words all = words;
  all.push_back("--output=none.exr");  // Required, and not used.
  if (pupil) all.push_back("--pupil=array");
  if (eyelashes) all.push_back("--eyelashes=array");
  parse(command, std::move(all));
  tool::TemplateArguments& a = request.arguments;
  request.pupil = array_input(pupil);
  request.eyelashes = array_input(eyelashes);
  use_array(request.pupil, a.pupil, "pupil", request);
  use_array(request.eyelashes, a.eyelashes, "eyelashes", request);
  tool::require_consistent(a);
  for (const LampArgument& lamp : lamps) request.lamps.push_back(lamp_of(lamp, request));
  return request;
}

/// One aperture's picture: the array, or the file where there is one.
std::optional<Aperture> picture(const std::optional<ArrayInput>& array, const std::string& file,
                                const TemplateOptions& options, Request& request) {
  if (array) return array->aperture;
  if (file.empty()) return std::nullopt;
  ApertureRead read =
      read_aperture({file, {}, request.arguments.width_mm, options.memory_limit_bytes});
  request.warnings.insert(request.warnings.end(), read.warnings.begin(), read.warnings.end());
  return std::move(read.aperture);
}

/// The aperture of the pictures, if there are any.
std::optional<Aperture> pictures(Request& request, const TemplateOptions& options) {
  const tool::TemplateArguments& a = request.arguments;
  auto front = picture(request.pupil, request.pupil ? "" : a.pupil, options, request);
  auto behind = picture(request.eyelashes, request.eyelashes ? "" : a.eyelashes, options, request);
  request.pupil.reset();
  request.eyelashes.reset();
  if (front && behind) return stacked(*front, *behind);
  return front ? std::move(front) : std::move(behind);
}

/// The wavelengths integrated over; an error names the lamp.
WavelengthRange range_of(const NamedLamp& lamp, const TemplateOptions& options) {
  try {
    return effective_range(lamp.spectrum, options);
  } catch (const InputError& error) {
    throw InputError("lamp " + lamp.name, error.message());
  }
}

tool::TemplateOptics optics_of(Request& request, const TemplateOptions& options) {
  auto aperture = pictures(request, options);
  if (aperture) return {request.arguments, options, std::move(*aperture)};
  return {request.arguments, options, tool::Console(tool::Verbosity::quiet)};
}

/// The lamps' places, those side by side that can share a far field, the widest range first.
std::vector<std::size_t> order_of(const std::vector<WavelengthRange>& ranges) {
  std::vector<std::size_t> order(ranges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(ranges[a].lo_nm, -ranges[a].hi_nm) <
           std::pair(ranges[b].lo_nm, -ranges[b].hi_nm);
  });
  return order;
}

/// The ranges of all lamps, with a warning for each that misses much of the light.
std::vector<WavelengthRange> ranges_of(Request& request, const TemplateOptions& options) {
  std::vector<WavelengthRange> ranges;
  for (const NamedLamp& lamp : request.lamps) {
    ranges.push_back(range_of(lamp, options));
    if (auto warning = tool::missed_light(lamp, options)) request.warnings.push_back(*warning);
  }
  return ranges;
}

/// The templates, in the lamps' order; those that can share a far field are made one after the
/// other.
std::vector<GlareTemplate> make(Request& request, const ProgressCallback& progress) {
  TemplateOptions options = tool::template_options(request.arguments);
  constexpr std::uint64_t kPixelBytes = 3 * sizeof(float);
  options.further_bytes += kPixelBytes * static_cast<std::uint64_t>(options.width) *
                           static_cast<std::uint64_t>(options.height) * request.lamps.size();
  const std::vector<WavelengthRange> ranges = ranges_of(request, options);
  const std::vector<std::size_t> order = order_of(ranges);

  tool::TemplateOptics optics = optics_of(request, options);
  for (const WavelengthRange& range : ranges) optics.require_possible(range);
  tool::RecipeWriter recipes(request.arguments, request.fingerprints);
  std::vector<GlareTemplate> made(ranges.size());
  const double count = static_cast<double>(order.size());
  double done = 0;
  for (const std::size_t i : order) {
    const auto part = [&](double from, double to) {
      return progress_part(progress, (done + from) / count, (done + to) / count);
    };
    if (!optics.serves(ranges[i])) optics.make_far_field(ranges[i], part(0, 0.5));
    const bool needs_aperture = options.aberrations.has_phase() || optics.is_dark();
    if (i == order.back() && !needs_aperture) optics.release_aperture();
    options.progress = part(0.5, 1);
    made[i] = tool::made_template(optics, request.lamps[i], options);
    made[i].recipe = recipes.recipe(request.lamps[i]);
    ++done;
  }
  return made;
}

/// (templates, warnings).
py::tuple make_templates(const Words& words, const std::optional<FloatArray>& pupil,
                         const std::optional<FloatArray>& eyelashes,
                         const std::vector<LampArgument>& lamps, const py::object& progress) {
  Request request = request_of(words, pupil, eyelashes, lamps);
  std::vector<GlareTemplate> made;
  run_released(progress, [&](const ProgressCallback& note) { made = make(request, note); });
  py::list templates;
  for (GlareTemplate& one : made)
    templates.append(std::make_shared<TemplateObject>(std::move(one)));
  return py::make_tuple(templates, request.warnings);
}

std::map<std::string, int> template_options_by_name() {
  tool::TemplateArguments arguments;
  CLI::App command;
  tool::add_template_options(command, arguments);
  return options_of(command);
}

}  // namespace

void add_template_making(py::module_& module) {
  module.def("template_options", &template_options_by_name);
  module.def("make_templates", &make_templates, py::arg("words"), py::arg("pupil").none(true),
             py::arg("eyelashes").none(true), py::arg("lamps"), py::arg("progress"));
}

}  // namespace glare::python
