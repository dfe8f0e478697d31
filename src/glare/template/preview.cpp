#include "glare/template/preview.h"

#include <algorithm>
#include <cmath>

#include "glare/color/gamut.h"

namespace glare {

namespace {

using Rgb = std::array<float, 3>;

float srgb_encoded(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  return static_cast<float>(v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055);
}

double largest_luminance(const GlareTemplate& t) {
  double largest = 0;
  for (int y = 0; y < t.height(); ++y)
    for (int x = 0; x < t.width(); ++x) largest = std::max(largest, t.luminance(x, y));
  return largest;
}

/// A colour of luminance 1 brought to `luminance`; where a channel would leave the display's range,
/// the colour moves towards grey until it stays inside.
Rgb displayed(const Rgb& unit_rgb, double luminance) {
  const double largest = std::max({unit_rgb[0], unit_rgb[1], unit_rgb[2]});
  double keep = 1;
  if (luminance * largest > 1) keep = (1 - luminance) / (luminance * (largest - 1));
  Rgb result;
  for (int k = 0; k < 3; ++k)
    result[k] = srgb_encoded(luminance * (1 + keep * (unit_rgb[k] - 1)));
  return result;
}

}  // namespace

Image<Rgb> preview(const GlareTemplate& t, const PreviewOptions& options) {
  const RgbColorSpace display = lin_rec709_color_space();
  const Matrix3 display_from_template = display.rgb_from_xyz() * t.color_space.xyz_from_rgb();
  const Vector3& weights = display.xyz_from_rgb()[1];
  const double middle = options.middle_luminance * largest_luminance(t);
  Image<Rgb> result(t.width(), t.height());
  for (int y = 0; y < t.height(); ++y)
    for (int x = 0; x < t.width(); ++x) {
      const double luminance = t.luminance(x, y);
      if (!(luminance > 0)) continue;
      const Vector3 v = display_from_template *
                        Vector3{t.channels[0](x, y), t.channels[1](x, y), t.channels[2](x, y)};
      const Rgb unit = desaturated_into_gamut({static_cast<float>(v[0] / luminance),
                                               static_cast<float>(v[1] / luminance),
                                               static_cast<float>(v[2] / luminance)},
                                              weights);
      const double c = std::pow(luminance / middle, 1 / options.compression);
      result(x, y) = displayed(unit, c / (c + 1));
    }
  return result;
}

}  // namespace glare
