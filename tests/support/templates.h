// Small templates with known units for tests, and what differs between two of them.
#pragma once

#include "glare/spectrum/spectrum.h"
#include "glare/template/glare_template.h"
#include "glare/template/make_template.h"
#include "support/apertures.h"

namespace glare::test {

/// A lamp of one narrow line: a triangle that is 0 at `half_width_nm` either side of its centre.
Spectrum line_lamp(double center_nm, double half_width_nm = 0.5);

/// A round pupil of 3 mm, 128 x 128 samples over 4 mm.
const Aperture& small_pupil();

/// Options for a quick template of it: 33 x 21 pixels, 0.3 degrees, two threads.
TemplateOptions small_options();

/// X, Y, Z per steradian in pixels of `pitch_rad`.
TemplateOptions absolute_xyz(int width, int height, double pitch_rad);

/// The Y channel of the template made with these options.
Image<float> luminance_of(const Aperture& aperture, const Spectrum& lamp,
                          const TemplateOptions& options);

/// An aperture with `transmittance(place)` in the middle of each of its samples.
template <typename Transmittance>
Aperture sampled(const Frame& frame, const Transmittance& transmittance) {
  Aperture out{Image<float>(frame.width_px, frame.height_px), frame.width_mm};
  for (int y = 0; y < frame.height_px; ++y)
    for (int x = 0; x < frame.width_px; ++x)
      out.transmittance(x, y) = static_cast<float>(
          transmittance(Place{(x + 0.5) * frame.pixel_mm() - frame.width_mm / 2,
                              (y + 0.5) * frame.pixel_mm() - frame.height_mm() / 2}));
  return out;
}

/// A picture whose value at (x, y) is `value(x, y)`.
template <typename Value>
Image<float> picture(int width, int height, const Value& value) {
  Image<float> out(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) out(x, y) = static_cast<float>(value(x, y));
  return out;
}

/// How far a picture is from another of the same size.
struct Difference {
  double of_peak = 0;   ///< Largest |a - b| over the largest |b|.
  double relative = 0;  ///< Largest |a - b| / |b| where |b| is at least 1e-5 of its largest.
};
Difference difference(const Image<float>& a, const Image<float>& b);

/// The values between x0 and x0 + width, y0 and y0 + height.
Image<float> cropped(const Image<float>& image, int x0, int y0, int width, int height);

}  // namespace glare::test
