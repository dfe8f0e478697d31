#include "glare/template/preview.h"

#include "glare/picture/picture.h"

namespace glare {

Image<std::array<float, 3>> preview(const GlareTemplate& t,
                                    const SigmoidToneMap& relative_tone_map) {
  const Matrix3 display_from_template =
      lin_rec709_color_space().rgb_from_xyz() * t.color_space.xyz_from_rgb();
  SigmoidToneMap tone_map = relative_tone_map;
  tone_map.middle_luminance *= median_luminance(t.channels, t.color_space);
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
