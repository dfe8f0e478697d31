#include "glare/template/grid_means.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "glare/base/parallel.h"

namespace glare {

namespace {

/// Rows or columns that are done together, side by side: a cache line.
constexpr int kLanes = 16;
using Lanes = std::array<float, kLanes>;

/// A part of an old pixel, and what of a new pixel's mean it gives by the old one's mean and the
/// densities at its ends.
struct Part {
  int pixel = 0;
  float mean = 0, begin = 0, end = 0;
};

/// What a new pixel is made of.
struct NewPixel {
  int first_whole = 0, end_whole = 0;  ///< Old pixels that are wholly in it.
  std::array<Part, 2> parts{};
  int part_count = 0;
};

/// How one axis' new pixels are made.
struct AxisPlan {
  std::vector<NewPixel> pixels;
  float whole_weight = 1;
  int first_old = 0, end_old = 0;  ///< The old pixels that are looked at.

  std::size_t old_count() const { return static_cast<std::size_t>(end_old - first_old); }
};

/// The light of an old pixel of unit length before t in it is this times its mean and densities.
std::array<double, 3> light_before(double t) {
  const double rest = 1 - t;
  return {t * t * (3 - 2 * t), t * rest * rest, -t * t * rest};
}

Part part_of(int pixel, double from, double to, double pitch_ratio) {
  const auto a = light_before(from), b = light_before(to);
  const auto weight = [&](std::size_t k) {
    return static_cast<float>((b[k] - a[k]) / pitch_ratio);
  };
  return {pixel, weight(0), weight(1), weight(2)};
}

/// From `begin` to `end` in old pixels, the first of which begins at 0.
NewPixel new_pixel(double begin, double end, int old_pixels, double pitch_ratio) {
  NewPixel result;
  begin = std::clamp(begin, 0.0, 1.0 * old_pixels);
  end = std::clamp(end, 0.0, 1.0 * old_pixels);
  if (!(begin < end)) return result;
  const auto add = [&](int pixel, double from, double to) {
    if (from < to)
      result.parts[static_cast<std::size_t>(result.part_count++)] =
          part_of(pixel, from, to, pitch_ratio);
  };
  const int first = static_cast<int>(begin), last = static_cast<int>(end);
  if (first == last) {
    add(first, begin - first, end - last);
    return result;
  }
  result.first_whole = static_cast<int>(std::ceil(begin));
  result.end_whole = last;
  if (first < result.first_whole) add(first, begin - first, 1);
  add(last, 0, end - last);
  return result;
}

AxisPlan axis_plan(int old_pixels, const GridAxis& axis) {
  AxisPlan plan;
  plan.whole_weight = static_cast<float>(1 / axis.pitch_ratio);
  plan.first_old = old_pixels;
  plan.pixels.reserve(static_cast<std::size_t>(axis.pixels));
  const auto border = [&](int i) {
    return (i - axis.pixels / 2 - 0.5 - axis.shift_px) * axis.pitch_ratio + (old_pixels / 2 + 0.5);
  };
  for (int i = 0; i < axis.pixels; ++i) {
    const NewPixel pixel = new_pixel(border(i), border(i + 1), old_pixels, axis.pitch_ratio);
    plan.pixels.push_back(pixel);
    const auto look_at = [&](int first, int end) {
      // With the neighbours that the densities at their ends depend on.
      plan.first_old = std::min(plan.first_old, std::max(first - 2, 0));
      plan.end_old = std::max(plan.end_old, std::min(end + 2, old_pixels));
    };
    if (pixel.first_whole < pixel.end_whole) look_at(pixel.first_whole, pixel.end_whole);
    for (int k = 0; k < pixel.part_count; ++k) {
      const int place = pixel.parts[static_cast<std::size_t>(k)].pixel;
      look_at(place, place + 1);
    }
  }
  plan.first_old = std::min(plan.first_old, plan.end_old);
  return plan;
}

/// The density between two pixels' means `b` and `c`, with `a` before and `d` behind them.
float density_between(float a, float b, float c, float d) {
  const float smooth = (7 * (b + c) - (a + d)) * (1.f / 12);
  const float least = std::min(b, c), largest = std::max(b, c);
  const float low = std::max(least, 2 * std::min(largest, 0.f));
  const float high = std::min(largest, 2 * std::max(least, 0.f));
  return std::min(std::max(smooth, low), high);
}

/// Some lanes' values, and what is made of them.
struct Workspace {
  std::vector<Lanes> means;      ///< Of the plan's old pixels.
  std::vector<Lanes> densities;  ///< Before each of these, and behind the last.
  std::vector<Lanes> result;     ///< Of the new pixels.
};

/// The first and last density that is looked at is a mean: beyond the picture nothing is known.
void find_densities(const std::vector<Lanes>& means, std::vector<Lanes>& densities) {
  const std::size_t count = means.size();
  densities.resize(count + 1);
  densities.front() = means.front();
  densities.back() = means.back();
  for (std::size_t i = 1; i < count; ++i) {
    const Lanes &a = means[i < 2 ? 0 : i - 2], &b = means[i - 1], &c = means[i],
                &d = means[std::min(i + 1, count - 1)];
    for (std::size_t k = 0; k < kLanes; ++k)
      densities[i][k] = density_between(a[k], b[k], c[k], d[k]);
  }
}

void make_pixel(const AxisPlan& plan, const NewPixel& pixel, const Workspace& old, Lanes& out) {
  Lanes sum{};
  for (int i = pixel.first_whole; i < pixel.end_whole; ++i) {
    const Lanes& mean = old.means[static_cast<std::size_t>(i - plan.first_old)];
    for (std::size_t k = 0; k < kLanes; ++k) sum[k] += mean[k];
  }
  for (std::size_t k = 0; k < kLanes; ++k) sum[k] *= plan.whole_weight;
  for (int p = 0; p < pixel.part_count; ++p) {
    const Part& part = pixel.parts[static_cast<std::size_t>(p)];
    const auto place = static_cast<std::size_t>(part.pixel - plan.first_old);
    const Lanes &mean = old.means[place], &begin = old.densities[place],
                &end = old.densities[place + 1];
    for (std::size_t k = 0; k < kLanes; ++k)
      sum[k] += part.mean * mean[k] + (part.begin * begin[k] + part.end * end[k]);
  }
  out = sum;
}

/// From `means` to `result`.
void make_pixels(const AxisPlan& plan, Workspace& work) {
  find_densities(work.means, work.densities);
  work.result.resize(plan.pixels.size());
  for (std::size_t i = 0; i < plan.pixels.size(); ++i)
    make_pixel(plan, plan.pixels[i], work, work.result[i]);
}

/// Rows `first_row` to `end_row` of the picture, with new pixels.
Image<float> rows_made(const Image<float>& picture, const AxisPlan& plan, int first_row,
                       int end_row, int threads) {
  const int rows = end_row - first_row;
  auto result = Image<float>::uninitialized(static_cast<int>(plan.pixels.size()), rows);
  WorkspacePool<Workspace> pool;
  parallel_for((rows + kLanes - 1) / kLanes, threads, [&](int block) {
    const auto work = pool.take();
    work->means.resize(plan.old_count());
    const int begin = block * kLanes, count = std::min(kLanes, rows - begin);
    for (int lane = 0; lane < count; ++lane) {
      const float* const values = picture.row(first_row + begin + lane).data() + plan.first_old;
      for (std::size_t i = 0; i < work->means.size(); ++i)
        work->means[i][static_cast<std::size_t>(lane)] = values[i];
    }
    make_pixels(plan, *work);
    for (int lane = 0; lane < count; ++lane) {
      float* const out = result.row(begin + lane).data();
      for (std::size_t i = 0; i < work->result.size(); ++i)
        out[i] = work->result[i][static_cast<std::size_t>(lane)];
    }
  });
  return result;
}

/// The picture, whose first row is the plan's first old pixel, with new rows.
Image<float> columns_made(const Image<float>& picture, const AxisPlan& plan, int threads) {
  const int width = picture.width();
  auto result = Image<float>::uninitialized(width, static_cast<int>(plan.pixels.size()));
  WorkspacePool<Workspace> pool;
  parallel_for((width + kLanes - 1) / kLanes, threads, [&](int block) {
    const auto work = pool.take();
    work->means.resize(plan.old_count());
    const int begin = block * kLanes;
    const auto count = static_cast<std::size_t>(std::min(kLanes, width - begin));
    for (int y = 0; y < picture.height(); ++y)
      std::copy_n(picture.row(y).data() + begin, count,
                  work->means[static_cast<std::size_t>(y)].data());
    make_pixels(plan, *work);
    for (int y = 0; y < result.height(); ++y)
      std::copy_n(work->result[static_cast<std::size_t>(y)].data(), count,
                  result.row(y).data() + begin);
  });
  return result;
}

}  // namespace

Image<float> grid_means(const Image<float>& picture, const GridAxis& across, const GridAxis& down,
                        int threads) {
  const AxisPlan columns = axis_plan(picture.width(), across);
  const AxisPlan rows = axis_plan(picture.height(), down);
  if (columns.old_count() == 0 || rows.old_count() == 0)
    return Image<float>(across.pixels, down.pixels);
  const Image<float> wide = rows_made(picture, columns, rows.first_old, rows.end_old, threads);
  return columns_made(wide, rows, threads);
}

}  // namespace glare
