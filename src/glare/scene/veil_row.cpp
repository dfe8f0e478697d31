#include "glare/scene/veil_row.h"

#include <algorithm>
#include <cstdint>

#include "glare/scene/veil_blocks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "glare/scene/veil_row.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>  // Compiles this file again for each instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glare {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A few of a block's pixels, side by side.
using Pixels = hn::CappedTag<float, 16>;
using PixelVector = hn::Vec<Pixels>;

/// How many columns and rows of the grid a pixel can overlap, and whether the grid's pixels blend.
template <std::size_t kTapsEachWay, bool kSoftGrid>
struct Window {
  static constexpr std::size_t kTaps = kTapsEachWay;
  static constexpr std::size_t kFours = (kTaps + 3) / 4;  ///< Columns are summed by fours.
  static constexpr bool kSoft = kSoftGrid;
};

/// A number at a few pixels.
HWY_INLINE PixelVector at(const Line& line, PixelVector i) {
  const Pixels d;
  return hn::MulAdd(i, hn::Set(d, line.step), hn::Set(d, line.start));
}

/// The profile of a pixel of the grid: a trapezium of area 1, flat to `inner`, 0 from `outer` on.
struct Profile {
  explicit Profile(double softness)
      : outer(static_cast<float>(0.5 * (1 + softness))),
        inner(static_cast<float>(0.5 * (1 - softness))),
        bend(softness > 0 ? static_cast<float>(0.5 / softness) : 0.f) {}

  /// The integral from the middle to `u`.
  HWY_INLINE PixelVector integral(PixelVector u) const {
    const Pixels d;
    const auto v = hn::Min(hn::Abs(u), hn::Set(d, outer));
    const auto slope = hn::Max(hn::Sub(v, hn::Set(d, inner)), hn::Zero(d));
    return hn::CopySign(hn::NegMulAdd(hn::Mul(slope, hn::Set(d, bend)), slope, v), u);
  }

  float outer, inner, bend;
};

/// Where pixels lie along one axis: the first tap, and their begins and ends from there.
struct Extent {
  PixelVector first_tap, begin, end, scale;
};

/// `shrink` is 1 / length of (right, down, 1); `axis` the grid's own place of 0.
HWY_INLINE Extent extent(const AxisLines& lines, PixelVector i, PixelVector shrink, double axis,
                         const Profile& profile) {
  const Pixels d;
  const auto middle = hn::MulAdd(at(lines.place, i), shrink, hn::Set(d, static_cast<float>(axis)));
  const auto half = at(lines.half, i);
  const auto reach = hn::Add(half, hn::Set(d, profile.outer - 1));
  const auto first_tap = hn::Floor(hn::Sub(middle, reach));
  const auto rest = hn::Sub(middle, first_tap);
  // So that the weights' sum is right between the block's ends too: a step of Newton's for 1 /
  // width.
  const auto width = hn::Add(half, half), guess = at(lines.scale, i);
  const auto scale = lines.even ? hn::Mul(guess, hn::NegMulAdd(width, guess, hn::Set(d, 2.f)))
                                : hn::Div(hn::Set(d, 1.f), width);
  return {first_tap, hn::Sub(rest, half), hn::Add(rest, half), scale};
}

/// The weights of the grid's pixels from the first tap on, of sum `total`.
template <typename Window>
HWY_INLINE std::array<PixelVector, Window::kTaps> weighed(const Extent& e, const Profile& profile,
                                                          float total) {
  const Pixels d;
  const auto scale = hn::Mul(hn::Set(d, total), e.scale);
  std::array<PixelVector, Window::kTaps> weights;
  for (std::size_t j = 0; j < Window::kTaps; ++j) {
    const auto tap = static_cast<float>(j);
    if constexpr (Window::kSoft) {
      const auto middle = hn::Set(d, tap);
      weights[j] = hn::Sub(profile.integral(hn::Sub(e.end, middle)),
                           profile.integral(hn::Sub(e.begin, middle)));
    } else if (j == 0) {  // Each pixel begins within the first tap.
      weights[j] = hn::Sub(hn::Min(e.end, hn::Set(d, 0.5f)), e.begin);
    } else {
      const auto side = hn::Set(d, tap - 0.5f);
      weights[j] = hn::Sub(hn::Clamp(e.end, side, hn::Set(d, tap + 0.5f)), side);
    }
    weights[j] = hn::Mul(scale, weights[j]);
  }
  return weights;
}

/// The weights of a block's pixels and where in the grid they begin.
template <typename Window>
struct Weights {
  /// By fours of columns, and in them by pixel.
  HWY_ALIGN std::array<std::array<float, 4 * kBlock>, Window::kFours> across;
  HWY_ALIGN std::array<std::array<float, kBlock>, Window::kTaps> down;
  HWY_ALIGN std::array<std::int32_t, kBlock> place;
};

#if HWY_TARGET == HWY_SCALAR

/// The weighted sum of a window of the grid, for pixel i.
template <typename Window>
HWY_INLINE void sum_window(const float* grid, std::size_t stride, const Weights<Window>& w,
                           std::size_t i, float* rgba) {
  for (std::size_t k = 0; k < 4; ++k) rgba[k] = 0;
  for (std::size_t j = 0; j < Window::kTaps; ++j)
    for (std::size_t t = 0; t < Window::kTaps; ++t)
      for (std::size_t k = 0; k < 4; ++k)
        rgba[k] += w.down[j][i] * w.across[t / 4][4 * i + t % 4] * grid[j * stride + 4 * t + k];
}

#else

/// A vector holds one or two of the grid's pixels.
#if HWY_HAVE_SCALABLE
using Taps = hn::FixedTag<float, 4>;
#else
using Taps = hn::CappedTag<float, 8>;
#endif
constexpr std::size_t kTapLanes = hn::MaxLanes(Taps());
constexpr std::size_t kTapsInVector = kTapLanes / 4;

/// Of four weights those of a vector's pixels, each four times.
HWY_INLINE hn::Vec<Taps> weights_of_vector(const float* across, std::size_t vector) {
  const Taps d;
  if constexpr (kTapLanes == 4) {
    return hn::Set(d, across[vector]);
  } else {
    HWY_ALIGN static constexpr std::int32_t kPixel[16] = {0, 0, 0, 0, 1, 1, 1, 1,
                                                          2, 2, 2, 2, 3, 3, 3, 3};
    const auto lanes = hn::SetTableIndices(d, kPixel + vector * kTapLanes);
    return hn::TableLookupLanes(hn::LoadDup128(d, across), lanes);
  }
}

/// The sum of the pixels in a vector.
template <typename V>
HWY_INLINE void store_sum(V sum, float* rgba) {
  const hn::DFromV<V> d;
  if constexpr (hn::MaxLanes(hn::DFromV<V>()) == 4) {
    hn::Store(sum, d, rgba);
  } else {
    const hn::Half<decltype(d)> half;
    store_sum(hn::Add(hn::LowerHalf(half, sum), hn::UpperHalf(half, sum)), rgba);
  }
}

/// The picture's next row is summed from the grid's next rows, which the processor wouldn't fetch
/// by itself until then; so far ahead along the row as a cache line is long.
constexpr std::size_t kTapsAhead = 4;

/// The weighted sum of a window of the grid, for pixel i: down each column first.
template <typename Window>
HWY_INLINE void sum_window(const float* grid, std::size_t stride, const Weights<Window>& w,
                           std::size_t i, float* rgba) {
  const Taps d;
  hwy::Prefetch(grid + Window::kTaps * stride + 4 * kTapsAhead);
  auto sum = hn::Zero(d);
  for (std::size_t tap = 0; tap < Window::kTaps; tap += kTapsInVector) {
    const float* row = grid + 4 * tap;
    auto column = hn::Mul(hn::Set(d, w.down[0][i]), hn::LoadU(d, row));
    for (std::size_t j = 1; j < Window::kTaps; ++j) {
      row += stride;
      column = hn::MulAdd(hn::Set(d, w.down[j][i]), hn::LoadU(d, row), column);
    }
    const float* const across = w.across[tap / 4].data() + 4 * i;
    sum = hn::MulAdd(weights_of_vector(across, tap % 4 / kTapsInVector), column, sum);
  }
  store_sum(sum, rgba);
}

#endif

/// Weighs a vector of pixels, from pixel i of the block on. False, and nothing else, where none of
/// them is within the grid.
template <typename Window>
HWY_INLINE bool weigh_pixels(const KernelGrid& grid, const Profile& profile,
                             const BlockLines& lines, std::size_t i, float illuminance_lux,
                             Weights<Window>& w) {
  const Pixels d;
  const auto index = hn::Iota(d, static_cast<float>(i));
  const auto right = at(lines.right, index);
  const auto square = hn::MulAdd(right, right, hn::Set(d, lines.down_square));
  const auto shrink = hn::Div(hn::Set(d, 1.f), hn::Sqrt(square));
  const Extent across = extent(lines.column, index, shrink, grid.axis_column, profile);
  const Extent along = extent(lines.row, index, shrink, grid.axis_row, profile);

  const auto within = [&](PixelVector tap, int size) {
    const auto last = hn::Set(d, static_cast<float>(size - KernelGrid::kBorder));
    return hn::And(hn::Ge(tap, hn::Zero(d)), hn::Le(tap, last));
  };
  const auto reached =
      hn::And(hn::Gt(at(lines.forward, index), hn::Zero(d)),
              hn::And(within(across.first_tap, grid.width), within(along.first_tap, grid.height)));
  if (hn::AllFalse(d, reached)) return false;

  const auto columns = weighed<Window>(across, profile, 1);
  const auto column = [&](std::size_t tap) {
    return tap < Window::kTaps ? columns[tap] : hn::Zero(d);
  };
  for (std::size_t four = 0; four < Window::kFours; ++four)
    hn::StoreInterleaved4(column(4 * four), column(4 * four + 1), column(4 * four + 2),
                          column(4 * four + 3), d, w.across[four].data() + 4 * i);
  const auto rows = weighed<Window>(along, profile, illuminance_lux);
  for (std::size_t j = 0; j < Window::kTaps; ++j) hn::Store(rows[j], d, w.down[j].data() + i);
  // The others are given the corner, where the border is 0.
  const hn::RebindToSigned<Pixels> whole;
  const auto left = hn::ConvertTo(whole, hn::IfThenElseZero(reached, across.first_tap));
  const auto top = hn::ConvertTo(whole, hn::IfThenElseZero(reached, along.first_tap));
  hn::Store(hn::Add(hn::Mul(top, hn::Set(whole, grid.width)), left), whole, w.place.data() + i);
  return true;
}

/// to[i] += values[i] for i < count, at most as many as a vector has.
HWY_INLINE void add_to(float* to, PixelVector values, std::size_t count) {
  const Pixels d;
  if (count >= hn::Lanes(d)) {
    hn::StoreU(hn::Add(hn::LoadU(d, to), values), d, to);
    return;
  }
  HWY_ALIGN std::array<float, hn::MaxLanes(Pixels())> rest;
  hn::Store(values, d, rest.data());
  for (std::size_t i = 0; i < count; ++i) to[i] += rest[i];
}

/// A row in blocks. What is stored for a block's vectors isn't waited for: each step is done for
/// all of them before the next.
template <typename Window>
HWY_INLINE void add_veil_of(const KernelGrid& grid, const VeilRow& pixels, std::size_t count,
                            float illuminance_lux, const std::array<float*, 3>& channels) {
  const Pixels d;
  const std::size_t lanes = hn::Lanes(d), stride = 4 * static_cast<std::size_t>(grid.width);
  const Profile profile(grid.softness);
  Weights<Window> w;
  HWY_ALIGN std::array<float, 4 * kBlock> rgba;
  std::array<std::size_t, kBlock> firsts;  // Of the vectors that the veil reaches.
  VeilBlocks blocks(pixels, static_cast<double>(Window::kTaps) - 1 - grid.softness);
  for (std::size_t block = 0; block < count; block += blocks.size()) {
    const BlockLines lines = blocks.next(block);
    std::size_t reached = 0;
    for (std::size_t i = 0; i < std::min(blocks.size(), count - block); i += lanes)
      if (weigh_pixels(grid, profile, lines, i, illuminance_lux, w)) firsts[reached++] = i;
    for (std::size_t v = 0; v < reached; ++v)
      for (std::size_t i = firsts[v]; i < firsts[v] + lanes; ++i)
        sum_window(grid.rgba.data() + 4 * static_cast<std::size_t>(w.place[i]), stride, w, i,
                   rgba.data() + 4 * i);
    for (std::size_t v = 0; v < reached; ++v) {
      const std::size_t first = block + firsts[v];
      std::array<PixelVector, 4> sums;
      hn::LoadInterleaved4(d, rgba.data() + 4 * firsts[v], sums[0], sums[1], sums[2], sums[3]);
      for (std::size_t k = 0; k < 3; ++k) add_to(channels[k] + first, sums[k], count - first);
    }
  }
}

void AddVeil(const KernelGrid& grid, const VeilRow& pixels, int count, float illuminance_lux,
             const std::array<float*, 3>& channels) {
  const auto n = static_cast<std::size_t>(std::max(0, count));
  const double widest_px = std::max(kNarrowestPixel, pixels.right.step / grid.pitch_rad);
  constexpr double kRounding = 1e-3;
  if (grid.softness > 0 && widest_px + grid.softness <= 1 + kRounding)
    add_veil_of<Window<2, true>>(grid, pixels, n, illuminance_lux, channels);
  else if (grid.softness > 0)
    add_veil_of<Window<4, true>>(grid, pixels, n, illuminance_lux, channels);
  else if (widest_px <= 1 + kRounding)
    add_veil_of<Window<2, false>>(grid, pixels, n, illuminance_lux, channels);
  else if (widest_px <= 2 + kRounding)
    add_veil_of<Window<3, false>>(grid, pixels, n, illuminance_lux, channels);
  else if (widest_px <= 3 + kRounding)
    add_veil_of<Window<4, false>>(grid, pixels, n, illuminance_lux, channels);
  else
    add_veil_of<Window<8, false>>(grid, pixels, n, illuminance_lux, channels);
}

}  // namespace HWY_NAMESPACE
}  // namespace glare
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glare {

HWY_EXPORT(AddVeil);

void add_veil(const KernelGrid& grid, const VeilRow& pixels, int count, float illuminance_lux,
              const std::array<float*, 3>& channels) {
  HWY_DYNAMIC_DISPATCH(AddVeil)(grid, pixels, count, illuminance_lux, channels);
}

}  // namespace glare

#endif  // HWY_ONCE
