#include "support/templates.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace glare::test {

Spectrum line_lamp(double center_nm, double half_width_nm) {
  return Spectrum({center_nm - half_width_nm, center_nm, center_nm + half_width_nm}, {0, 1, 0});
}

const Aperture& small_pupil() {
  static const Aperture pupil = circle({128, 128, 4}, 3);
  return pupil;
}

TemplateOptions small_options() {
  TemplateOptions options;
  options.width = 33;
  options.height = 21;
  options.field_of_view_deg = 0.3;
  options.threads = 2;
  return options;
}

TemplateOptions absolute_xyz(int width, int height, double pitch_rad) {
  TemplateOptions options;
  options.width = width;
  options.height = height;
  options.field_of_view_deg = pitch_rad * width * 180 / std::numbers::pi;
  options.color_space = xyz_color_space();
  options.normalization = Normalization::absolute;
  options.threads = 2;
  return options;
}

Image<float> luminance_of(const Aperture& aperture, const Spectrum& lamp,
                          const TemplateOptions& options) {
  return make_template(aperture, lamp, options).channels[1];
}

Difference difference(const Image<float>& a, const Image<float>& b) {
  if (a.width() != b.width() || a.height() != b.height())
    throw std::invalid_argument("pictures of different sizes");
  double largest = 0;
  for (const float value : b.values()) largest = std::max<double>(largest, std::abs(value));
  Difference out;
  for (std::size_t i = 0; i < a.values().size(); ++i) {
    const double expected = b.values()[i], off = std::abs(a.values()[i] - expected);
    if (!(off <= largest)) return {1, 1};  // Also where a value isn't a number.
    out.of_peak = std::max(out.of_peak, off / largest);
    if (std::abs(expected) >= 1e-5 * largest)
      out.relative = std::max(out.relative, off / std::abs(expected));
  }
  return out;
}

Image<float> cropped(const Image<float>& image, int x0, int y0, int width, int height) {
  return picture(width, height, [&](int x, int y) { return image(x0 + x, y0 + y); });
}

}  // namespace glare::test
