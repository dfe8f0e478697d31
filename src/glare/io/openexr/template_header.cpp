#include "glare/io/openexr/template_header.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "glare/base/error.h"
#include "glare/base/units.h"
#include "glare/io/openexr/rgb_pixels.h"

namespace glare::openexr_io {

namespace {

constexpr int kFormatVersion = 1;
constexpr const char* kCieScatter = "cie146";

// To the file.

Imath::V2f vector_of(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

void insert_float(Imf::Header& header, const char* name, double value) {
  header.insert(name, Imf::FloatAttribute(static_cast<float>(value)));
}

void insert_string(Imf::Header& header, const char* name, const std::string& value) {
  header.insert(name, Imf::StringAttribute(value));
}

void insert_xyz(Imf::Header& header, const char* name, const Xyz& xyz) {
  header.insert(name, Imf::V3fAttribute({static_cast<float>(xyz[0]), static_cast<float>(xyz[1]),
                                         static_cast<float>(xyz[2])}));
}

void insert_scatter(Imf::Header& header, const Straylight& eye, double scattered_energy) {
  insert_string(header, "glare:scatter", kCieScatter);
  insert_float(header, "glare:scatterAge_years", eye.age_years);
  insert_float(header, "glare:scatterPigment", eye.pigment);
  insert_float(header, "glare:scatteredEnergy", scattered_energy);
}

void insert_attributes(Imf::Header& header, const GlareTemplate& t) {
  const auto center = t.center_px();
  header.insert("glare:formatVersion", Imf::IntAttribute(kFormatVersion));
  insert_float(header, "glare:pixelPitch_deg", t.pixel_pitch_deg());
  header.insert("glare:center_px", Imf::V2fAttribute(vector_of(center[0], center[1])));
  insert_string(header, "glare:colorSpace", t.color_space.name());
  insert_string(header, "glare:normalization", to_string(t.normalization));
  insert_float(header, "glare:perSteradian", t.per_steradian);
  insert_float(header, "glare:capturedEnergy", t.captured_energy);
  insert_xyz(header, "glare:lampXYZ", t.lamp_xyz);
  insert_xyz(header, "glare:lightXYZ", t.light_xyz);
  insert_string(header, "glare:lamp", t.lamp);
  insert_string(header, "glare:observer", t.observer);
  header.insert(
      "glare:wavelengthRange_nm",
      Imf::V2fAttribute(vector_of(t.wavelength_range_nm.lo_nm, t.wavelength_range_nm.hi_nm)));
  insert_float(header, "glare:apertureWidth_mm", t.aperture_width_mm);
  insert_float(header, "glare:apertureArea_mm2", t.aperture_area_mm2);
  if (t.scatter) insert_scatter(header, *t.scatter, t.scattered_energy);
  if (!t.aberrations.empty()) insert_string(header, "glare:aberrations", t.aberrations);
  insert_string(header, "glare:recipe", t.recipe);
  insert_string(header, "glare:software", t.software);
}

// From the file.

std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

/// Reads typed attributes from a header; a missing one, or one of another type, is an error.
class AttributeReader {
 public:
  AttributeReader(const Imf::Header& header, const std::string& place)
      : header_(header), place_(place) {}

  [[noreturn]] void fail(const std::string& message) const { throw InputError(place_, message); }

  template <typename Attribute>
  const auto& value(const std::string& name) const {
    const auto* const attribute = header_.findTypedAttribute<Attribute>(name);
    if (attribute) return attribute->value();
    if (header_.find(name) == header_.end())
      fail("is no glare template: the attribute " + name + " is missing");
    fail("the attribute " + name + " is of another type, " + header_[name].typeName());
  }
  double number(const std::string& name) const {
    const double number = value<Imf::FloatAttribute>(name);
    if (!std::isfinite(number)) fail("the attribute " + name + " isn't finite");
    return number;
  }
  double not_negative(const std::string& name) const {
    const double value = number(name);
    if (!(value >= 0)) fail("the attribute " + name + " is negative");
    return value;
  }
  double positive(const std::string& name) const {
    const double positive = number(name);
    if (!(positive > 0)) fail("the attribute " + name + " isn't positive");
    return positive;
  }
  /// Within limits, as far as 32-bit floats can tell.
  double number(const std::string& name, double least, double largest) const {
    const double number = this->number(name);
    if (number < static_cast<float>(least) || number > static_cast<float>(largest))
      fail("the attribute " + name + " isn't between " + text_of(least) + " and " +
           text_of(largest));
    return std::clamp(number, least, largest);
  }
  Xyz xyz(const std::string& name) const {
    const auto& vector = value<Imf::V3fAttribute>(name);
    return {vector.x, vector.y, vector.z};
  }
  bool has(const std::string& name) const { return header_.find(name) != header_.end(); }
  const std::string& text(const std::string& name) const {
    return value<Imf::StringAttribute>(name);
  }
  const Imf::Header& header() const { return header_; }

 private:
  const Imf::Header& header_;
  const std::string& place_;
};

RgbColorSpace color_space_of(const AttributeReader& reader) {
  const std::string& name = reader.text("glare:colorSpace");
  if (reader.header().channels().findChannel("X")) return {name, identity_matrix()};
  const auto& c = reader.value<Imf::ChromaticitiesAttribute>("chromaticities");
  try {
    return {name,
            {{{c.red.x, c.red.y}, {c.green.x, c.green.y}, {c.blue.x, c.blue.y}}},
            xyz_from_chromaticity({c.white.x, c.white.y})};
  } catch (const InputError& error) {
    reader.fail("the attribute chromaticities: " + error.message());
  }
}

/// A template without straylight has none of these attributes.
void read_scatter(const AttributeReader& reader, GlareTemplate& t) {
  if (!reader.has("glare:scatter")) return;
  if (const std::string& name = reader.text("glare:scatter"); name != kCieScatter)
    reader.fail("has glare:scatter '" + name + "'; this program reads cie146");
  t.scatter = Straylight{reader.number("glare:scatterAge_years", 0, kOldestStraylight_years),
                         reader.number("glare:scatterPigment", 0, kPalestStraylight)};
  t.scattered_energy = reader.number("glare:scatteredEnergy", 0, 1);
}

void read_attributes(const AttributeReader& reader, GlareTemplate& t) {
  if (const int version = reader.value<Imf::IntAttribute>("glare:formatVersion");
      version != kFormatVersion)
    reader.fail("has glare:formatVersion " + std::to_string(version) +
                "; this program reads version 1");
  t.color_space = color_space_of(reader);
  t.pixel_pitch_rad = reader.positive("glare:pixelPitch_deg") * kRadPerDeg;
  t.normalization = normalization_from(reader.text("glare:normalization"));
  t.per_steradian = reader.positive("glare:perSteradian");
  t.captured_energy = reader.number("glare:capturedEnergy");
  t.lamp_xyz = reader.xyz("glare:lampXYZ");
  t.light_xyz = reader.has("glare:lightXYZ") ? reader.xyz("glare:lightXYZ") : t.lamp_xyz;
  t.lamp = reader.text("glare:lamp");
  t.observer = reader.text("glare:observer");
  const auto& range = reader.value<Imf::V2fAttribute>("glare:wavelengthRange_nm");
  t.wavelength_range_nm = {range.x, range.y};
  t.aperture_width_mm = reader.positive("glare:apertureWidth_mm");
  t.aperture_area_mm2 = reader.not_negative("glare:apertureArea_mm2");
  read_scatter(reader, t);
  if (reader.header().find("glare:aberrations") != reader.header().end())
    t.aberrations = reader.text("glare:aberrations");
  t.recipe = reader.text("glare:recipe");
  t.software = reader.text("glare:software");
}

void require_channels_and_center(const AttributeReader& reader, const GlareTemplate& t, int width,
                                 int height) {
  for (const char* name : channel_names(t.color_space))
    if (!reader.header().channels().findChannel(name))
      reader.fail(std::string("has no channel ") + name);
  const auto& center = reader.value<Imf::V2fAttribute>("glare:center_px");
  if (center != vector_of(width / 2, height / 2))
    reader.fail("glare:center_px isn't (width / 2, height / 2)");
}

}  // namespace

Imf::Header header_of(const GlareTemplate& t, bool half) {
  Imf::Header header = rgb_header(t.width(), t.height(), t.color_space, half);
  insert_attributes(header, t);
  return header;
}

GlareTemplate template_of(const Imf::Header& header, const std::string& place) {
  const AttributeReader reader(header, place);
  GlareTemplate t;
  read_attributes(reader, t);
  const Imath::Box2i& window = header.dataWindow();
  const int width = window.max.x - window.min.x + 1;
  const int height = window.max.y - window.min.y + 1;
  require_channels_and_center(reader, t, width, height);
  t.channels.fill(Image<float>(width, height));
  return t;
}

}  // namespace glare::openexr_io
