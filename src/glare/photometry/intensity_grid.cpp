#include "glare/photometry/intensity_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "glare/base/error.h"
#include "glare/base/parallel.h"
#include "glare/photometry/text_reading.h"

namespace glare {

namespace {

void require_range(const std::array<double, 2>& range_deg, double low, double high,
                   const char* name) {
  const auto [first, last] = range_deg;
  if (first >= low && last <= high && first < last) return;  // False for NaN, too.
  throw OptionError("the image's " + std::string(name) + " goes from " +
                    photometry::text_of(first) + " to " + photometry::text_of(last) +
                    " degrees; expected an ascending range within " + photometry::text_of(low) +
                    " to " + photometry::text_of(high));
}

std::vector<double> steps_deg(const std::array<double, 2>& range_deg, int count) {
  std::vector<double> angles_deg;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    angles_deg.push_back((1 - share) * range_deg[0] + share * range_deg[1]);
  }
  return angles_deg;
}

Image<float> upside_down(const Image<float>& image) {
  Image<float> turned(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    std::ranges::copy(image.row(y), turned.row(image.height() - 1 - y).begin());
  return turned;
}

}  // namespace

void require_intensity_grid(const IntensityGrid& grid) {
  require_range(grid.h_deg, -360, 720, "H");
  require_range(grid.v_deg, -90, 90, "V");
  if (grid.h_deg[1] - grid.h_deg[0] > 360)
    throw OptionError("the image's H spans more than 360 degrees");
  constexpr int kMostSide = 65535;
  if (std::min(grid.width, grid.height) < 2 || std::max(grid.width, grid.height) > kMostSide)
    throw OptionError("the image of intensities is " + std::to_string(grid.width) + " x " +
                      std::to_string(grid.height) + " pixels; expected 2 to 65535 each");
}

LuminousIntensityDistribution on_grid(const LuminousIntensityDistribution& distribution,
                                      const IntensityGrid& grid, const Mounting& mounting,
                                      int threads, const ProgressCallback& progress) {
  require_intensity_grid(grid);
  const auto h_deg = steps_deg(grid.h_deg, grid.width);
  const auto v_deg = steps_deg(grid.v_deg, grid.height);
  Image<float> candela(grid.width, grid.height);
  const auto fill_row = [&](int j) {
    for (int i = 0; i < grid.width; ++i)
      candela(i, j) = static_cast<float>(distribution.towards(
          direction_from_angles(PhotometricType::a, h_deg[static_cast<std::size_t>(i)],
                                v_deg[static_cast<std::size_t>(j)]),
          mounting));
  };
  parallel_for(grid.height, threads, fill_row, progress);
  return {PhotometricType::a, h_deg, v_deg, std::move(candela)};
}

LuminousIntensityDistribution distribution_from_image(const Image<float>& candela,
                                                      const IntensityGrid& grid) {
  require_intensity_grid(grid);
  return {PhotometricType::a, steps_deg(grid.h_deg, grid.width), steps_deg(grid.v_deg, grid.height),
          upside_down(candela)};
}

Image<float> image_from_distribution(const LuminousIntensityDistribution& distribution) {
  assert(distribution.type() == PhotometricType::a);
  return upside_down(distribution.candela());
}

}  // namespace glare
