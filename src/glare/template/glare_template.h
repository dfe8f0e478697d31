// The glare template: what an eye sees around a point of light, as a picture with its scale.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "glare/base/image.h"
#include "glare/color/color_space.h"
#include "glare/scatter/straylight.h"
#include "glare/spectrum/spectrum.h"

namespace glare {

enum class Normalization {
  peak,     ///< The luminance of the brightest pixel is 1.
  energy,   ///< The luminances of the pixels sum to 1.
  absolute  ///< Per steradian: E lux at the eye make a veil of E times the luminance, in cd/m^2.
};

/// "peak", "energy" or "absolute", and back; `OptionError` for another name.
std::string to_string(Normalization normalization);
Normalization normalization_from(const std::string& name);

/// A picture of direction sines around the axis of the eye. Right and down in it are right and down
/// in the aperture's picture.
struct GlareTemplate {
  /// R, G, B of `color_space` (X, Y, Z for "xyz"), scene-linear, the mean over each pixel's square.
  std::array<Image<float>, 3> channels;
  RgbColorSpace color_space = lin_rec709_color_space();

  double pixel_pitch_rad = 0;  ///< Direction sine from pixel to pixel, both ways.
  Normalization normalization = Normalization::peak;
  double per_steradian = 0;    ///< Multiply a luminance by this to have it per steradian.
  double captured_energy = 0;  ///< Share of all the light that falls on the pixels, 0 to 1.

  Xyz lamp_xyz{};  ///< The lamp's colour at Y = 1 (before any adaptation of white).
  /// The colour at Y = 1 of all the template's light, over all directions, as its pixels have it:
  /// `lamp_xyz`, or the colour space's white, where white was adapted to the lamp.
  Xyz light_xyz{};
  std::string lamp;         ///< Name or file name.
  std::string observer;     ///< Name.
  std::string aberrations;  ///< Of the eye; empty where there are none.
  WavelengthRange wavelength_range_nm;
  double aperture_width_mm = 0;
  double aperture_area_mm2 = 0;  ///< The integral of t^2.

  std::optional<Straylight> scatter;  ///< The eye whose straylight is in it, if any is.
  double scattered_energy = 0;        ///< Share of all the light, 0 to 1, that is straylight.

  std::string recipe;    ///< How to make it again: every option, and each input's SHA-256.
  std::string software;  ///< Name and version of the program that made it.

  int width() const { return channels[0].width(); }
  int height() const { return channels[0].height(); }
  /// Column and row of the pixel whose centre is the axis.
  std::array<int, 2> center_px() const { return {width() / 2, height() / 2}; }
  double pixel_pitch_deg() const;
  /// Luminance of a pixel in the template's own normalisation; of the adapted colour, where white
  /// was adapted to the lamp.
  double luminance(int x, int y) const;
};

/// Scales the pixels so that a luminance of 1 is `per_steradian` (> 0), whatever the brightest
/// pixel then is: so the frames of a sequence have one scale.
void rescale(GlareTemplate& glare_template, double per_steradian);

}  // namespace glare
