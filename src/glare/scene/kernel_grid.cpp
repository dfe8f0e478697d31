#include "glare/scene/kernel_grid.h"

#include <algorithm>
#include <cmath>

#include "glare/template/resampled.h"

namespace glare {

namespace {

/// An odd number of pixels about the axis: those of the template, no further than `reach`.
int size_within(int template_pixels, double pitch_ratio, double reach_px) {
  const int all = covering_size(template_pixels, pitch_ratio);
  if (reach_px >= all / 2) return all;
  return 2 * static_cast<int>(std::ceil(reach_px)) + 1;
}

}  // namespace

KernelGrid kernel_grid(const GlareTemplate& t, const Matrix3& picture_from_template,
                       double pitch_rad, double reach, double softness) {
  KernelGrid grid;
  grid.pitch_rad = std::max(pitch_rad, t.pixel_pitch_rad);
  grid.softness = softness;
  const double ratio = grid.pitch_rad / t.pixel_pitch_rad;
  const int width = size_within(t.width(), ratio, reach / grid.pitch_rad);
  const int height = size_within(t.height(), ratio, reach / grid.pitch_rad);
  std::array<Image<float>, 3> channels;
  for (std::size_t k = 0; k < 3; ++k) channels[k] = area_means(t.channels[k], ratio, width, height);

  constexpr int kBorder = KernelGrid::kBorder;
  grid.width = width + 2 * kBorder;
  grid.height = height + 2 * kBorder;
  grid.axis_column = kBorder + width / 2;
  grid.axis_row = kBorder + height / 2;
  const auto row_floats = 4 * static_cast<std::size_t>(grid.width);
  grid.rgba.assign(row_floats * static_cast<std::size_t>(grid.height), 0.f);
  for (int y = 0; y < height; ++y) {
    float* out =
        grid.rgba.data() + static_cast<std::size_t>(y + kBorder) * row_floats + 4 * kBorder;
    for (int x = 0; x < width; ++x, out += 4)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3& m = picture_from_template[k];
        out[k] = static_cast<float>(
            t.per_steradian *
            (m[0] * channels[0](x, y) + m[1] * channels[1](x, y) + m[2] * channels[2](x, y)));
      }
  }
  return grid;
}

}  // namespace glare
