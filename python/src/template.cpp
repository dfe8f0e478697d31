// The class Template: what a template is, and files of it.

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bindings.h"
#include "command_words.h"
#include "glare/base/error.h"
#include "glare/io/memory.h"
#include "glare/io/template_file.h"
#include "glare/template/profile.h"
#include "interruptible.h"
#include "template_object.h"

namespace glare::python {

namespace py = pybind11;

namespace {

/// The recipe with or without "--half", as the file that it goes to. One that isn't the command's
/// stays as it is.
std::string recipe_for(const std::string& recipe, bool half) {
  auto whole = nlohmann::ordered_json::parse(recipe, nullptr, false);
  if (!whole.is_object() || !whole.contains("command") || !whole["command"].is_array())
    return recipe;
  auto words = nlohmann::ordered_json::array();
  for (const auto& word : whole["command"])
    if (word != "--half") words.push_back(word);
  if (half) words.push_back("--half");
  whole["command"] = words;
  return whole.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void save(const TemplateObject& object, const std::filesystem::path& path, bool half, int threads,
          const py::object& progress) {
  if (threads < 0 || threads > 1024) throw OptionError("threads must be 0 to 1024");
  run_released(progress, [&](const ProgressCallback& keep_going) {
    GlareTemplate whole = object.whole();
    whole.recipe = recipe_for(whole.recipe, half);
    write_template(path, whole, {half, threads, [&] { return keep_going(0); }});
  });
}

TemplateObject read(const std::filesystem::path& path,
                    const std::variant<std::uint64_t, std::string>& memory_limit) {
  const auto* const size = std::get_if<std::string>(&memory_limit);
  const std::uint64_t memory_limit_bytes =
      size != nullptr ? memory_bytes(*size) : std::get<std::uint64_t>(memory_limit);
  std::optional<GlareTemplate> result;
  const std::uint64_t limit =
      memory_limit_bytes != 0 ? memory_limit_bytes : default_memory_limit_bytes();
  run_released(py::none(), [&](const ProgressCallback&) { result = read_template(path, {limit}); });
  return TemplateObject(std::move(*result));
}

/// A column of the profile.
template <typename Value>
py::array_t<double> column(const std::vector<ProfileRing>& rings, const Value& value) {
  py::array_t<double> result(static_cast<py::ssize_t>(rings.size()));
  for (std::size_t i = 0; i < rings.size(); ++i)
    result.mutable_at(static_cast<py::ssize_t>(i)) = value(rings[i], i);
  return result;
}

py::tuple profile(const TemplateObject& object) {
  const auto rings = radial_profile(object.whole());
  return py::make_tuple(
      column(rings, [](const ProfileRing& ring, std::size_t) { return ring.inner_deg; }),
      column(rings, [](const ProfileRing& ring, std::size_t) { return ring.outer_deg; }),
      column(rings, [](const ProfileRing& ring, std::size_t) { return ring.mean_per_steradian; }));
}

py::array_t<double> cie_column(const TemplateObject& object, double age, double pigment) {
  const GlareTemplate whole = object.whole();
  const auto rings = radial_profile(whole);
  const auto values = cie_profile(whole, rings, {age, pigment});
  return column(rings, [&](const ProfileRing&, std::size_t i) {
    return values[i].value_or(std::numeric_limits<double>::quiet_NaN());
  });
}

py::array_t<double> encircled(const TemplateObject& object, const std::vector<double>& radii_deg) {
  const GlareTemplate whole = object.whole();
  py::array_t<double> result(static_cast<py::ssize_t>(radii_deg.size()));
  for (std::size_t i = 0; i < radii_deg.size(); ++i)
    result.mutable_at(static_cast<py::ssize_t>(i)) =
        std::isnan(radii_deg[i]) ? radii_deg[i]
                                 : encircled_energy(whole, radii_deg[i])
                                       .value_or(std::numeric_limits<double>::quiet_NaN());
  return result;
}

py::tuple brightest(const TemplateObject& object) {
  const Peak found = peak(object.whole());
  return py::make_tuple(found.x, found.y, found.luminance);
}

py::array_t<double> xyz_from_rgb(const TemplateObject& object) {
  py::array_t<double> result({3, 3});
  const Matrix3& m = object.facts().color_space.xyz_from_rgb();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      result.mutable_at(row, column) =
          m[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  return result;
}

std::string representation(const TemplateObject& object) {
  const GlareTemplate& facts = object.facts();
  char text[200];
  std::snprintf(text, sizeof text,
                ", %d x %d pixels of %.4g degrees, %s, %s: %.4g %% of the light, 1 is %.6g per sr>",
                object.width(), object.height(), facts.pixel_pitch_deg(),
                facts.color_space.name().c_str(), to_string(facts.normalization).c_str(),
                100 * facts.captured_energy, facts.per_steradian);
  return "<glare.Template of lamp " + facts.lamp + text;
}

py::tuple tuple_of(const Xyz& xyz) { return py::make_tuple(xyz[0], xyz[1], xyz[2]); }

using Class = py::class_<TemplateObject, std::shared_ptr<TemplateObject>>;

/// A read-only property of the facts.
template <typename Get>
void add_fact(Class& c, const char* name, const char* meaning, Get get) {
  c.def_property_readonly(
      name, [get](const TemplateObject& object) { return get(object.facts()); }, meaning);
}

void add_pixels(Class& c) {
  c.def_property_readonly("rgb", &TemplateObject::rgb,
                          "(h, w, 3) float32, read-only and no copy: R, G, B (X, Y, Z for "
                          "colorspace 'xyz'), scene-linear, each the mean over its pixel.");
  c.def_property_readonly("luminance", &TemplateObject::luminance,
                          "(h, w) float32: luminance, in the template's own normalization.");
  c.def_property_readonly("width", &TemplateObject::width, "Pixels across.");
  c.def_property_readonly("height", &TemplateObject::height, "Pixels down.");
  c.def_property_readonly(
      "center_px",
      [](const TemplateObject& t) { return py::make_tuple(t.width() / 2, t.height() / 2); },
      "(column, row) of the pixel whose centre is the axis.");
  c.def_property_readonly("xyz_from_rgb", &xyz_from_rgb,
                          "(3, 3) float64: CIE XYZ of a pixel is this matrix times its R, G, B.");
}

void add_facts(Class& c) {
  using T = GlareTemplate;
  add_fact(c, "pixel_pitch_deg", "Direction sine from pixel to pixel, times 180/pi.",
           [](const T& t) { return t.pixel_pitch_deg(); });
  add_fact(c, "pixel_pitch_rad", "Direction sine from pixel to pixel.",
           [](const T& t) { return t.pixel_pitch_rad; });
  add_fact(c, "per_steradian", "Multiply a luminance by this to have it per steradian.",
           [](const T& t) { return t.per_steradian; });
  add_fact(c, "captured_energy", "Share of all the light that falls on the pixels, 0 to 1.",
           [](const T& t) { return t.captured_energy; });
  add_fact(c, "normalization", "'peak', 'energy' or 'absolute'.",
           [](const T& t) { return to_string(t.normalization); });
  add_fact(c, "colorspace", "Name of the colour space.",
           [](const T& t) { return t.color_space.name(); });
  add_fact(c, "lamp", "The lamp's name or file name.", [](const T& t) { return t.lamp; });
  add_fact(c, "lamp_xyz", "(X, Y, Z) of the lamp, Y = 1.",
           [](const T& t) { return tuple_of(t.lamp_xyz); });
  add_fact(c, "light_xyz",
           "(X, Y, Z) at Y = 1 of all the light as the pixels have it: the lamp's, or the colour "
           "space's white where white is adapted to the lamp.",
           [](const T& t) { return tuple_of(t.light_xyz); });
  add_fact(c, "observer", "Name of the CIE standard observer.",
           [](const T& t) { return t.observer; });
  add_fact(c, "wavelength_range_nm", "(shortest, longest) wavelength integrated over, in nm.",
           [](const T& t) {
             return py::make_tuple(t.wavelength_range_nm.lo_nm, t.wavelength_range_nm.hi_nm);
           });
  add_fact(c, "aberrations", "Of the eye, as text; empty where there are none.",
           [](const T& t) { return t.aberrations; });
  add_fact(c, "aperture_width_mm", "Width of the aperture's picture, in mm.",
           [](const T& t) { return t.aperture_width_mm; });
  add_fact(c, "aperture_area_mm2", "Integral of the squared transmittance, in mm^2.",
           [](const T& t) { return t.aperture_area_mm2; });
  add_fact(c, "scattered_energy", "Share of all the light that is straylight, 0 to 1.",
           [](const T& t) { return t.scattered_energy; });
  add_fact(c, "recipe", "JSON text: the command that makes it, and each input's SHA-256.",
           [](const T& t) { return t.recipe; });
  add_fact(c, "software", "Name and version of the program that made it.",
           [](const T& t) { return t.software; });
}

}  // namespace

void add_template(py::module_& module) {
  Class c(module, "Template",
          "A glare template: what an eye sees around a point of light, with its scale.\n\n"
          "Made by template(), templates() and read_template(); can't be changed.");
  add_pixels(c);
  add_facts(c);
  c.def("_radial_profile", &profile);
  c.def("_cie_profile", &cie_column, py::arg("age"), py::arg("pigment"));
  c.def("_encircled_energy", &encircled, py::arg("radii_deg"));
  c.def("peak", &brightest, "(column, row, luminance) of the brightest pixel.");
  c.def(
      "chromaticity",
      [](const TemplateObject& object) {
        const Chromaticity xy = mean_chromaticity(object.whole());
        return py::make_tuple(xy.x, xy.y);
      },
      "CIE (x, y) of all the light in the template together.");
  c.def("save", &save, py::arg("path"), py::kw_only(), py::arg("half") = false,
        py::arg("threads") = 0, py::arg("progress") = py::none(),
        "Writes an OpenEXR file, all or nothing, the same bytes as the command's.\n\n"
        "half: 16-bit floats. Raises OutputError; OptionError where half can't hold the values.");
  c.def("__repr__", &representation);
  module.def("read_template", &read, py::arg("path"), py::kw_only(), py::arg("memory_limit") = 0,
             "Reads a template that save() or the program glare wrote.\n\n"
             "memory_limit: bytes or '4GB'; 0: three quarters of the machine's. Raises InputError, "
             "MemoryLimitError.");
}

}  // namespace glare::python
