#include "glare/aperture/aperture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "glare/base/error.h"

namespace glare {

namespace {

std::string size_text(const Image<float>& image) {
  return std::to_string(image.width()) + " x " + std::to_string(image.height());
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

/// Whether the heights agree to within rounding when both pictures are as wide as `fine`.
bool same_shape(const Image<float>& fine, const Image<float>& coarse) {
  const double scale = static_cast<double>(fine.width()) / coarse.width();
  constexpr double most = 0.01;  // of the height: what rounding a picture's size explains
  return std::abs(fine.height() - coarse.height() * scale) <=
         std::min(0.5 * scale, most * fine.height());
}

void require_same_rectangle(const Aperture& fine, const Aperture& coarse) {
  constexpr double tolerance = 1e-6;  // widths read from a file or a command line
  if (!(std::abs(fine.width_mm - coarse.width_mm) <= tolerance * fine.width_mm))
    throw InputError("", "the aperture images are " + number_text(fine.width_mm) + " mm and " +
                             number_text(coarse.width_mm) + " mm wide, expected equal widths");
  if (!same_shape(fine.transmittance, coarse.transmittance))
    throw InputError("", "the aperture images are " + size_text(fine.transmittance) + " and " +
                             size_text(coarse.transmittance) +
                             " pixels, expected the same shape (width : height)");
}

double sinc(double x) {
  if (std::abs(x) < 1e-12) return 1;
  return std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

constexpr int tap_count = 8;

/// What one new sample takes of the old ones: weights that sum to 1, and where they apply.
struct Taps {
  std::array<int, tap_count> index;
  std::array<double, tap_count> weight;
};

/// Lanczos' kernel, sinc(x) sinc(x / 4), at `position` in old samples (their centres are at
/// integers); beyond the edges the outermost sample goes on.
Taps lanczos_taps(double position, int old_size) {
  constexpr int half = tap_count / 2;
  const int first = static_cast<int>(std::floor(position)) - half + 1;
  Taps taps;
  double sum = 0;
  for (int k = 0; k < tap_count; ++k) {
    const double distance = position - (first + k);
    taps.index[k] = std::clamp(first + k, 0, old_size - 1);
    taps.weight[k] = sinc(distance) * sinc(distance / half);
    sum += taps.weight[k];
  }
  for (double& weight : taps.weight) weight /= sum;
  return taps;
}

/// The taps of every new sample, for samples at the centres of `old_size` and of `new_size` equal
/// parts of the same length.
std::vector<Taps> enlarging_taps(int old_size, int new_size) {
  std::vector<Taps> taps;
  taps.reserve(new_size);
  const double scale = static_cast<double>(old_size) / new_size;
  for (int i = 0; i < new_size; ++i)
    taps.push_back(lanczos_taps((i + 0.5) * scale - 0.5, old_size));
  return taps;
}

Image<float> widened(const Image<float>& image, int width) {
  const std::vector<Taps> taps = enlarging_taps(image.width(), width);
  Image<float> result(width, image.height());
  for (int y = 0; y < image.height(); ++y) {
    const std::span<const float> from = image.row(y);
    const std::span<float> to = result.row(y);
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int k = 0; k < tap_count; ++k) sum += taps[x].weight[k] * from[taps[x].index[k]];
      to[x] = static_cast<float>(sum);
    }
  }
  return result;
}

Image<float> heightened(const Image<float>& image, int height) {
  const std::vector<Taps> taps = enlarging_taps(image.height(), height);
  Image<float> result(image.width(), height);
  std::vector<double> sum(image.width());
  for (int y = 0; y < height; ++y) {
    std::fill(sum.begin(), sum.end(), 0.0);
    for (int k = 0; k < tap_count; ++k) {
      const std::span<const float> from = image.row(taps[y].index[k]);
      for (int x = 0; x < image.width(); ++x) sum[x] += taps[y].weight[k] * from[x];
    }
    std::copy(sum.begin(), sum.end(), result.row(y).begin());
  }
  return result;
}

/// The values that a transmittance may have.
struct Values {
  float least, most;
};

void require_transmittance(float value, int x, int y, const Values& expected) {
  if (value >= expected.least && value <= expected.most) return;
  throw InputError("aperture pixel (" + std::to_string(x) + ", " + std::to_string(y) + ")",
                   "transmittance is " + number_text(value) + ", expected " +
                       number_text(expected.least) + " to " + number_text(expected.most));
}

}  // namespace

double energy_area_mm2(const Aperture& aperture) {
  if (aperture.unlimited_energy_area_mm2) return *aperture.unlimited_energy_area_mm2;
  double sum = 0;
  for (const float t : aperture.transmittance.values()) sum += static_cast<double>(t) * t;
  return sum * aperture.pixel_mm() * aperture.pixel_mm();
}

void require_valid(const Aperture& aperture) {
  const Image<float>& image = aperture.transmittance;
  if (image.width() < 2 || image.height() < 2)
    throw InputError("", "the aperture is " + size_text(image) + " pixels, expected 2 x 2 or more");
  if (!(std::isfinite(aperture.width_mm) && aperture.width_mm > 0))
    throw InputError("", "the aperture is " + number_text(aperture.width_mm) +
                             " mm wide, expected a positive width");
  const Values expected = aperture.unlimited_energy_area_mm2 ? Values{-0.5f, 1.5f} : Values{0, 1};
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) require_transmittance(image.row(y)[x], x, y, expected);
  if (!(energy_area_mm2(aperture) > 0))
    throw InputError("", "the aperture is opaque everywhere, expected some light to get through");
}

Aperture stacked(const Aperture& front, const Aperture& behind) {
  const bool front_is_finer = front.transmittance.width() >= behind.transmittance.width();
  const Aperture& fine = front_is_finer ? front : behind;
  const Aperture& coarse = front_is_finer ? behind : front;
  assert(!fine.unlimited_energy_area_mm2 && !coarse.unlimited_energy_area_mm2);
  require_same_rectangle(fine, coarse);

  Aperture result{
      enlarged(coarse.transmittance, fine.transmittance.width(), fine.transmittance.height()),
      fine.width_mm};
  const std::span<float> product = result.transmittance.values();
  const std::span<const float> factor = fine.transmittance.values();
  for (std::size_t i = 0; i < product.size(); ++i) product[i] *= factor[i];
  return result;
}

Image<float> enlarged(const Image<float>& image, int width, int height) {
  assert(!image.empty() && width >= image.width() && height >= image.height());
  if (width == image.width() && height == image.height()) return image;
  Image<float> result = heightened(widened(image, width), height);
  for (float& t : result.values()) t = std::clamp(t, 0.0f, 1.0f);
  return result;
}

}  // namespace glare
