#include "glare/convolution/roll_off.h"

#include <cmath>
#include <numbers>

#include "glare/base/range_check.h"

namespace glare {

namespace {

/// 1 inside the fade, 0 from the radius on.
double window(double r, double share) {
  if (r >= 1) return 0;
  if (r <= 1 - share) return 1;
  const double c = std::cos(std::numbers::pi / 2 * (r - 1 + share) / share);
  return c * c;
}

}  // namespace

std::array<double, 3> roll_off(PixelKernel& kernel, const RollOff& options) {
  require_in_range("the roll-off's radius across in pixels", options.radius_x_px, 1, 1 << 30);
  require_in_range("the roll-off's radius down in pixels", options.radius_y_px, 1, 1 << 30);
  require_in_range("the roll-off's share of the radius", options.share, 0, 1);
  std::array<double, 3> taken{};
  for (int y = 0; y < kernel.height(); ++y)
    for (int x = 0; x < kernel.width(); ++x) {
      const double r = std::hypot(double(x - kernel.width() / 2) / options.radius_x_px,
                                  double(y - kernel.height() / 2) / options.radius_y_px);
      const double w = window(r, options.share);
      if (w == 1) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        float& share = kernel.channels[k](x, y);
        const float faded = w == 0 ? 0 : static_cast<float>(share * w);
        taken[k] += double{share} - double{faded};
        share = faded;
      }
    }
  for (std::size_t k = 0; k < 3; ++k) {
    kernel.captured[k] -= taken[k];
    kernel.kept[k] += taken[k];
  }
  return taken;
}

}  // namespace glare
