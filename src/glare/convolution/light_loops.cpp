#include "glare/convolution/light_loops.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "glare/convolution/light_loops.cpp"
#include <hwy/foreach_target.h>  // Compiles this file again for each instruction set.
#include <hwy/highway.h>

#ifndef GLARE_LIGHT_LOOPS_LINE
#define GLARE_LIGHT_LOOPS_LINE
namespace glare {
/// Pixels that are done at once, a multiple of any vector's length.
inline constexpr std::size_t kPixels = 16;
using PixelBlock = std::array<std::array<float, kPixels>, 3>;
}  // namespace glare
#endif

HWY_BEFORE_NAMESPACE();
namespace glare {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, kPixels>;
using Vector = hn::Vec<Floats>;
using Mask = hn::Mask<Floats>;

struct Light {
  std::array<Vector, 3> exposed, light;
  Mask finite;
};

/// Of the pixels at `pixels[k]`.
HWY_INLINE Light LightOf(const BrightCurve& curve, const std::array<const float*, 3>& pixels,
                         std::size_t at) {
  const Floats d;
  const auto zero = hn::Zero(d), largest = hn::Set(d, std::numeric_limits<float>::max());
  const auto exposure = hn::Set(d, curve.exposure);
  Light out;
  for (std::size_t k = 0; k < 3; ++k)
    out.exposed[k] = hn::Mul(exposure, hn::LoadU(d, pixels[k] + at));
  const auto all =
      hn::Max(hn::Abs(out.exposed[0]), hn::Max(hn::Abs(out.exposed[1]), hn::Abs(out.exposed[2])));
  // Max may give either operand where one is not a number: each is looked at for it.
  out.finite = hn::And(
      hn::And(hn::Le(all, largest), hn::Eq(out.exposed[0], out.exposed[0])),
      hn::And(hn::Eq(out.exposed[1], out.exposed[1]), hn::Eq(out.exposed[2], out.exposed[2])));
  for (std::size_t k = 0; k < 3; ++k)
    out.light[k] = hn::IfThenElseZero(out.finite, hn::Max(out.exposed[k], zero));
  if (curve.all_light) return out;
  auto luminance = zero;
  for (std::size_t k = 0; k < 3; ++k)
    luminance = hn::MulAdd(hn::Set(d, curve.luminance_weights[k]), out.light[k], luminance);
  luminance = hn::Min(luminance, largest);
  const auto above = hn::Max(hn::Sub(luminance, hn::Set(d, curve.start)), zero);
  const auto in_step = hn::Min(above, hn::Set(d, curve.step));
  const auto spread =
      hn::MulAdd(in_step, hn::Mul(in_step, hn::Set(d, curve.parabola)), hn::Sub(above, in_step));
  const auto share = hn::IfThenElseZero(hn::Gt(above, zero), hn::Div(spread, luminance));
  for (auto& light : out.light) light = hn::Mul(light, share);
  return out;
}

HWY_INLINE void CountUnusable(const Light& light, UnusablePixels& unusable) {
  const Floats d;
  const auto zero = hn::Zero(d);
  const auto negative =
      hn::Or(hn::Or(hn::Lt(light.exposed[0], zero), hn::Lt(light.exposed[1], zero)),
             hn::Lt(light.exposed[2], zero));
  if (hn::AllTrue(d, light.finite) && hn::AllFalse(d, negative)) return;
  const auto known = hn::And(hn::Eq(light.exposed[0], light.exposed[0]),
                             hn::And(hn::Eq(light.exposed[1], light.exposed[1]),
                                     hn::Eq(light.exposed[2], light.exposed[2])));
  const std::size_t lanes = hn::Lanes(d), numbers = hn::CountTrue(d, known),
                    usable = hn::CountTrue(d, light.finite);
  unusable.nan += lanes - numbers;
  unusable.infinite += numbers - usable;
  unusable.negative += hn::CountTrue(d, hn::And(light.finite, negative));
}

/// Of `count` pixels, a multiple of kPixels.
void TakeLight(const BrightCurve& curve, const std::array<const float*, 3>& pixels,
               std::size_t count, float scale, const std::array<float*, 3>& result,
               UnusablePixels& unusable) {
  const Floats d;
  const auto factor = hn::Set(d, scale);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const Light light = LightOf(curve, pixels, i);
    CountUnusable(light, unusable);
    for (std::size_t k = 0; k < 3; ++k)
      hn::StoreU(hn::Mul(light.light[k], factor), d, result[k] + i);
  }
}

void AddGlare(const BrightCurve& curve, const GlareSum& sum,
              const std::array<const float*, 3>& spread, std::size_t count,
              const std::array<float*, 3>& pixels) {
  const Floats d;
  const auto scale = hn::Set(d, 1 / sum.light_scale), strength = hn::Set(d, sum.strength);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const Light light = LightOf(curve, {pixels[0], pixels[1], pixels[2]}, i);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto others = hn::Max(hn::LoadU(d, spread[k] + i), hn::Set(d, sum.least[k]));
      const auto change =
          hn::MulAdd(hn::Set(d, sum.own[k]), light.light[k], hn::Mul(others, scale));
      const auto added = hn::Mul(strength, change);
      const auto whole =
          hn::IfThenElse(light.finite, hn::Add(light.exposed[k], added), light.exposed[k]);
      hn::StoreU(sum.only_glare ? added : whole, d, pixels[k] + i);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace glare
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glare {

namespace {

HWY_EXPORT(TakeLight);
HWY_EXPORT(AddGlare);

template <typename T>
std::array<T*, 3> line(const ChannelLines<T>& lines, std::size_t row, std::size_t column) {
  std::array<T*, 3> result = lines.channels;
  for (T*& channel : result) channel += row * lines.stride + column;
  return result;
}

template <typename T>
PixelBlock padded(const std::array<T*, 3>& line, std::size_t count) {
  PixelBlock block{};
  for (std::size_t k = 0; k < 3; ++k) std::copy_n(line[k], count, block[k].begin());
  return block;
}

void copy_back(const PixelBlock& block, std::size_t count, const std::array<float*, 3>& line) {
  for (std::size_t k = 0; k < 3; ++k) std::copy_n(block[k].begin(), count, line[k]);
}

std::array<float*, 3> pointers(PixelBlock& block) {
  return {block[0].data(), block[1].data(), block[2].data()};
}

std::array<const float*, 3> constant(const std::array<float*, 3>& line) {
  return {line[0], line[1], line[2]};
}

}  // namespace

UnusablePixels take_light(const BrightCurve& curve, const ChannelLines<const float>& pixels,
                          std::size_t rows, std::size_t columns, float scale,
                          const ChannelLines<float>& light) {
  const auto run = HWY_DYNAMIC_DISPATCH(TakeLight);
  const std::size_t rest = columns % kPixels, most = columns - rest;
  UnusablePixels unusable;
  for (std::size_t y = 0; y < rows; ++y) {
    run(curve, line(pixels, y, 0), most, scale, line(light, y, 0), unusable);
    if (rest == 0) continue;
    PixelBlock block = padded(line(pixels, y, most), rest);
    run(curve, constant(pointers(block)), kPixels, scale, pointers(block), unusable);
    copy_back(block, rest, line(light, y, most));
  }
  return unusable;
}

void add_glare(const BrightCurve& curve, const GlareSum& sum,
               const ChannelLines<const float>& spread, std::size_t rows, std::size_t columns,
               const ChannelLines<float>& pixels) {
  const auto run = HWY_DYNAMIC_DISPATCH(AddGlare);
  const std::size_t rest = columns % kPixels, most = columns - rest;
  for (std::size_t y = 0; y < rows; ++y) {
    run(curve, sum, line(spread, y, 0), most, line(pixels, y, 0));
    if (rest == 0) continue;
    PixelBlock block = padded(line(pixels, y, most), rest);
    PixelBlock added = padded(line(spread, y, most), rest);
    run(curve, sum, constant(pointers(added)), kPixels, pointers(block));
    copy_back(block, rest, line(pixels, y, most));
  }
}

}  // namespace glare

#endif  // HWY_ONCE
