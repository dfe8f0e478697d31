#include "glare/convolution/point_sources.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "glare/base/error.h"
#include "glare/base/parallel.h"
#include "glare/base/range_check.h"
#include "glare/convolution/kernel_source.h"
#include "glare/convolution/shifted_kernel.h"

namespace glare {

namespace {

// The brightest pixels.

/// What a value gives as light.
double light_of(float value) { return value > 0 && std::isfinite(value) ? value : 0; }

Vector3 sums_of_light(const Picture& light) {
  Vector3 sums{};
  for (std::size_t k = 0; k < 3; ++k)
    for (const float value : light.channels[k].values()) sums[k] += light_of(value);
  return sums;
}

struct Candidate {
  double brightness = 0;
  std::size_t pixel = 0;
};

/// The first of equally bright ones counts as the brighter.
bool is_brighter(const Candidate& a, const Candidate& b) {
  return a.brightness != b.brightness ? a.brightness > b.brightness : a.pixel < b.pixel;
}

/// Keeps the `count` brightest, in no order; there are more.
void keep_brightest(std::vector<Candidate>& candidates, std::size_t count) {
  std::nth_element(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count),
                   candidates.end(), is_brighter);
  candidates.resize(count);
}

/// At most `most` pixels, the brightest first. A pixel's brightness is the sum of its shares of the
/// channels' light.
std::vector<Candidate> brightest(const Picture& light, const Vector3& sums, std::size_t most) {
  Vector3 weights{};
  for (std::size_t k = 0; k < 3; ++k) weights[k] = sums[k] > 0 ? 1 / sums[k] : 0;
  const auto a = light.channels[0].values(), b = light.channels[1].values(),
             c = light.channels[2].values();
  std::vector<Candidate> candidates;
  double least = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double brightness =
        weights[0] * light_of(a[i]) + weights[1] * light_of(b[i]) + weights[2] * light_of(c[i]);
    if (!(brightness > least)) continue;
    candidates.push_back({brightness, i});
    if (candidates.size() < 2 * most + 1000) continue;
    keep_brightest(candidates, most);
    for (const Candidate& candidate : candidates)
      if (&candidate == &candidates.front() || candidate.brightness < least)
        least = candidate.brightness;
  }
  if (candidates.size() > most) keep_brightest(candidates, most);
  std::sort(candidates.begin(), candidates.end(), is_brighter);
  return candidates;
}

PointSource point_at(const Picture& light, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(light.width());
  PointSource point{static_cast<double>(pixel % width), static_cast<double>(pixel / width), {}};
  for (std::size_t k = 0; k < 3; ++k)
    point.light[k] = static_cast<float>(light_of(light.channels[k].values()[pixel]));
  return point;
}

/// Whether a border that goes on gives no light.
bool has_dark_border(const Picture& light) {
  const int right = light.width() - 1, bottom = light.height() - 1;
  return std::ranges::all_of(light.channels, [&](const Image<float>& channel) {
    for (int x = 0; x <= right; ++x)
      if (channel(x, 0) != 0 || channel(x, bottom) != 0) return false;
    for (int y = 0; y <= bottom; ++y)
      if (channel(0, y) != 0 || channel(right, y) != 0) return false;
    return true;
  });
}

// Their glare.

/// A point by the pixel that it is in.
struct PlacedPoint {
  int x = 0, y = 0;
  double shift_x_px = 0, shift_y_px = 0;  ///< From the pixel's centre to the kernel's axis.
  std::array<float, 3> light{};
};

bool have_equal_shifts(const PlacedPoint& a, const PlacedPoint& b) {
  return a.shift_x_px == b.shift_x_px && a.shift_y_px == b.shift_y_px;
}

void require_valid(std::span<const PointSource> points, const PointGlareOptions& options) {
  require_in_range("the strength", options.strength, 0, 1000);
  require_in_range("the shift across in pixels", options.kernel.shift_x_px, -0.5, 0.5);
  require_in_range("the shift down in pixels", options.kernel.shift_y_px, -0.5, 0.5);
  for (const PointSource& point : points)
    if (!std::isfinite(point.x_px + point.y_px) ||
        !std::isfinite(point.light[0] + point.light[1] + point.light[2]))
      throw OptionError("a point's place or light isn't finite");
}

/// The points whose glare may reach the picture, those of equal shifts together.
std::vector<PlacedPoint> placed(std::span<const PointSource> points, const Picture& picture,
                                const std::array<double, 2>& farthest_px,
                                const PixelKernelOptions& options) {
  const auto is_near = [](double place, int size, double farthest) {
    return place > -farthest - 1 && place < size + farthest;
  };
  std::vector<PlacedPoint> result;
  for (const PointSource& point : points) {
    const double x = point.x_px + options.shift_x_px, y = point.y_px + options.shift_y_px;
    if (!is_near(x, picture.width(), farthest_px[0]) ||
        !is_near(y, picture.height(), farthest_px[1]))
      continue;
    const double column = std::floor(x + 0.5), row = std::floor(y + 0.5);
    result.push_back(
        {static_cast<int>(column), static_cast<int>(row), x - column, y - row, point.light});
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return std::tie(a.shift_y_px, a.shift_x_px) < std::tie(b.shift_y_px, b.shift_x_px);
  });
  return result;
}

/// How far from a point, at most, the picture's pixels are.
int reach_within(int size, int place) {
  return std::max(std::abs(place), std::abs(size - 1 - place));
}

/// The kernel of a point at a pixel's centre, as far as any of the points needs it.
PixelKernel centered_kernel(const KernelSource& source, std::span<const PlacedPoint> points,
                            const Picture& picture, const PointGlareOptions& options) {
  int reach_x_px = 1, reach_y_px = 1;
  for (const PlacedPoint& point : points) {  // And a pixel more, for what a shift brings in.
    reach_x_px = std::max(reach_x_px, reach_within(picture.width(), point.x) + 1);
    reach_y_px = std::max(reach_y_px, reach_within(picture.height(), point.y) + 1);
  }
  if (options.kernel.reach_x_px > 0) reach_x_px = std::min(reach_x_px, options.kernel.reach_x_px);
  if (options.kernel.reach_y_px > 0) reach_y_px = std::min(reach_y_px, options.kernel.reach_y_px);
  return source.kernel(reach_x_px, reach_y_px, options.threads);
}

/// Adds a kernel about one point to one row.
void add_to_row(const Image<float>& kernel, const PlacedPoint& point, float light, int y,
                std::span<float> row) {
  const int kernel_y = y - point.y + kernel.height() / 2;
  if (kernel_y < 0 || kernel_y >= kernel.height()) return;
  const int first = point.x - kernel.width() / 2;
  const int begin = std::max(first, 0);
  const int end = std::min(first + kernel.width(), static_cast<int>(row.size()));
  if (begin >= end) return;
  const float* const values = kernel.row(kernel_y).data() + (begin - first);
  float* const out = row.data() + begin;
  for (int i = 0; i < end - begin; ++i) out[i] += light * values[i];
}

/// Adds to the four pixels around a place, as far as they are in the picture.
void add_at(Image<float>& channel, double x_px, double y_px, double light) {
  const double left = std::floor(x_px), top = std::floor(y_px);
  for (int dy = 0; dy < 2; ++dy)
    for (int dx = 0; dx < 2; ++dx) {
      const double x = left + dx, y = top + dy;
      const double weight = (1 - std::abs(x_px - x)) * (1 - std::abs(y_px - y));
      if (weight == 0 || x < 0 || y < 0 || x >= channel.width() || y >= channel.height()) continue;
      channel(static_cast<int>(x), static_cast<int>(y)) += static_cast<float>(weight * light);
    }
}

/// Adds the glare of points of equal shifts.
void add_group(std::span<const PlacedPoint> points, const PixelKernel& kernel,
               const PointGlareOptions& options, const ProgressCallback& progress,
               std::array<Image<float>, 3>& added) {
  const auto strength = static_cast<float>(options.strength);
  const auto add_row = [&](int y) {
    for (std::size_t k = 0; k < 3; ++k)
      for (const PlacedPoint& point : points)
        add_to_row(kernel.channels[k], point, strength * point.light[k], y, added[k].row(y));
  };
  parallel_for(added[0].height(), options.threads, add_row, progress);
}

/// The glare of all points, without what is taken from their own pixels.
std::array<Image<float>, 3> glare_around(const std::vector<PlacedPoint>& points,
                                         const KernelSource& source, const Picture& picture,
                                         const PointGlareOptions& options) {
  std::array<Image<float>, 3> added;
  added.fill(Image<float>(picture.width(), picture.height()));
  const auto done = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(points.size());
  };
  if (points.empty()) return added;
  const PixelKernel centered = centered_kernel(source, points, picture, options);
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    while (end < points.size() && have_equal_shifts(points[begin], points[end])) ++end;
    const auto group = std::span(points).subspan(begin, end - begin);
    add_group(group, shifted(centered, group[0].shift_x_px, group[0].shift_y_px, options.threads),
              options, progress_part(options.progress, done(begin), done(end)), added);
  }
  return added;
}

}  // namespace

std::optional<std::vector<PointSource>> bright_points(const Picture& light, double share,
                                                      int most) {
  require_in_range("the share of the light", share, 0, 1);
  // Sums of doubles in another order: each step is good to 1e-16.
  constexpr double kRounding = 1e-11;
  const Vector3 sums = sums_of_light(light);
  const auto candidates = brightest(light, sums, static_cast<std::size_t>(std::max(most, 0)));
  std::vector<PointSource> points;
  std::vector<std::size_t> pixels;
  Vector3 held{};
  const auto is_enough = [&] {
    for (std::size_t k = 0; k < 3; ++k)
      if (held[k] < share * sums[k] * (1 - kRounding)) return false;
    return true;
  };
  for (auto next = candidates.begin(); !is_enough(); ++next) {
    if (next == candidates.end()) return std::nullopt;
    pixels.push_back(next->pixel);
    const PointSource point = point_at(light, next->pixel);
    for (std::size_t k = 0; k < 3; ++k) held[k] += point.light[k];
  }
  std::sort(pixels.begin(), pixels.end());
  for (const std::size_t pixel : pixels) points.push_back(point_at(light, pixel));
  return points;
}

std::optional<std::vector<PointSource>> few_points(const Picture& light, Edge edge) {
  constexpr double kShare = 0.9995;  // What is left out changes the added light by twice as much.
  constexpr int kMost = 300;         // They take about as long as the convolution.
  if (edge == Edge::extend && !has_dark_border(light)) return std::nullopt;
  return bright_points(light, kShare, kMost);
}

void add_point_glare(Picture& picture, std::span<const PointSource> points,
                     const GlareTemplate& glare_template, const PixelScale& scale,
                     const PointGlareOptions& options) {
  require_valid(points, options);
  const KernelSource source(glare_template, scale, picture.color_space, options.kernel);
  auto added = glare_around(placed(points, picture, source.farthest_px(), options.kernel), source,
                            picture, options);
  const auto& kept = source.kept();
  for (const PointSource& point : points)
    for (std::size_t k = 0; k < 3; ++k)
      add_at(
          added[k], point.x_px, point.y_px,
          (options.strength * (kept[k] - 1) + (options.points_are_new ? 1 : 0)) * point.light[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto out = picture.channels[k].values();
    const auto values = added[k].values();
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += values[i];
  }
}

}  // namespace glare
