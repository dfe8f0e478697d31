#include "glare/io/openexr/camera_attributes.h"

#include <OpenEXR/ImfBoxAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <charconv>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>

namespace glare::openexr_io {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;

using Told = std::optional<ToldPixelPitch>;

template <typename Value>
const Value* value_of(const Imf::Header& header, const char* name) {
  const auto* const attribute = header.findTypedAttribute<Imf::TypedAttribute<Value>>(name);
  return attribute ? &attribute->value() : nullptr;
}

/// A number in an attribute of type float, or as the text of one; 0 where there is none.
double number_of(const Imf::Header& header, const char* name) {
  if (const auto* const number = value_of<float>(header, name)) return *number;
  const auto* const text = value_of<std::string>(header, name);
  double number = 0;
  if (text) std::from_chars(text->data(), text->data() + text->size(), number);
  return number;
}

double display_width(const Imf::Header& header) {
  const auto [min, max] = header.displayWindow();
  return static_cast<double>(max.x) - min.x + 1;
}

/// Nothing is seen in smaller pixels than of a hundredth of a thousandth of a second of arc, nor
/// are there larger ones than of half a turn.
Told plausible(double pitch_rad, const std::string& source) {
  constexpr double least_rad = 5e-11;
  if (!(pitch_rad >= least_rad && pitch_rad <= std::numbers::pi)) return {};
  return ToldPixelPitch{pitch_rad, source};
}

/// The pitch at the centre of a perspective picture of this whole angle.
Told from_whole_angle(const Imf::Header& header) {
  const double fov_deg = number_of(header, "glare:horizontalFov_deg");
  if (!(fov_deg > 0 && fov_deg < 180)) return {};
  return plausible(2 * std::tan(0.5 * fov_deg * kRadPerDeg) / display_width(header),
                   "glare:horizontalFov_deg");
}

/// Width of the light that the picture's display window has, in mm; 0 where nothing tells it.
double sensor_width_mm(const Imf::Header& header, std::string& source) {
  const double photosite_mm = 1e-3 * number_of(header, "sensorPhotositePitch");  // In micrometres.
  const auto* const used = value_of<Imath::Box2i>(header, "sensorAcquisitionRectangle");
  if (photosite_mm > 0) {
    source = used ? "sensorPhotositePitch, sensorAcquisitionRectangle" : "sensorPhotositePitch";
    return photosite_mm *
           (used ? static_cast<double>(used->max.x) - used->min.x + 1 : display_width(header));
  }
  if (const auto* const whole_mm = value_of<Imath::V2f>(header, "sensorOverallDimensions")) {
    source = "sensorOverallDimensions";
    return whole_mm->x;
  }
  return 0;
}

Told from_sensor(const Imf::Header& header) {
  std::string source;
  const double width_mm = sensor_width_mm(header, source);
  for (const char* name : {"pinholeFocalLength", "effectiveFocalLength", "nominalFocalLength"}) {
    const double focal_length_mm = number_of(header, name);
    if (!(focal_length_mm > 0 && width_mm > 0)) continue;
    if (const Told told = plausible(width_mm / focal_length_mm / display_width(header),
                                    std::string(name) + ", " + source))
      return told;
  }
  return {};
}

/// From the matrix that makes camera coordinates (z along the view) the display window's, both 0 to
/// 1 across it: a point (x, 0, z) has u = (x m00 + z m20 + m30) / (x m03 + z m23 + m33).
Told from_matrices(const Imf::Header& header) {
  const auto* const world_to_camera = value_of<Imath::M44f>(header, "worldToCamera");
  const auto* const world_to_ndc = value_of<Imath::M44f>(header, "worldToNDC");
  if (!world_to_camera || !world_to_ndc) return {};
  const Imath::M44d camera(*world_to_camera), ndc(*world_to_ndc);
  if (std::abs(camera.determinant()) < 1e-30) return {};
  const Imath::M44d m = camera.inverse() * ndc;
  // A perspective: the divisor is z alone.
  const double scale = std::abs(m[2][3]);
  if (!(scale > 0) || std::abs(m[0][3]) > 1e-4 * scale || std::abs(m[3][3]) > 1e-4 * scale)
    return {};
  return plausible(scale / (std::abs(m[0][0]) * display_width(header)),
                   "worldToCamera, worldToNDC");
}

/// The display window's width at a distance of 1. Of pictures that tell nothing it is 1.
Told from_screen_window(const Imf::Header& header) {
  const double width = header.screenWindowWidth();
  if (width == 1) return {};
  return plausible(width / display_width(header), "screenWindowWidth");
}

}  // namespace

std::optional<ToldPixelPitch> told_pixel_pitch(const Imf::Header& header) {
  if (const Told own =
          plausible(kRadPerDeg * number_of(header, "glare:pixelPitch_deg"), "glare:pixelPitch_deg"))
    return own;
  for (const auto told : {from_whole_angle, from_sensor, from_matrices, from_screen_window})
    if (const Told pitch = told(header)) return pitch;
  return {};
}

}  // namespace glare::openexr_io
