#include "glare/template/preview.h"

#include <algorithm>
#include <vector>

namespace glare {

namespace {

/// The luminance in the middle of all pixels', of those that have any.
double median_luminance(const GlareTemplate& t) {
  std::vector<double> luminances;
  luminances.reserve(t.channels[0].values().size());
  for (int y = 0; y < t.height(); ++y)
    for (int x = 0; x < t.width(); ++x)
      if (const double luminance = t.luminance(x, y); luminance > 0)
        luminances.push_back(luminance);
  if (luminances.empty()) return 1;
  const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
  std::nth_element(luminances.begin(), middle, luminances.end());
  return *middle;
}

}  // namespace

Image<std::array<float, 3>> preview(const GlareTemplate& t,
                                    const SigmoidToneMap& relative_tone_map) {
  const Matrix3 display_from_template =
      lin_rec709_color_space().rgb_from_xyz() * t.color_space.xyz_from_rgb();
  SigmoidToneMap tone_map = relative_tone_map;
  tone_map.middle_luminance *= median_luminance(t);
  Image<std::array<float, 3>> result(t.width(), t.height());
  for (int y = 0; y < t.height(); ++y)
    for (int x = 0; x < t.width(); ++x) {
      const Vector3 rgb = display_from_template *
                          Vector3{t.channels[0](x, y), t.channels[1](x, y), t.channels[2](x, y)};
      result(x, y) = tone_map(
          {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])});
    }
  return result;
}

}  // namespace glare
