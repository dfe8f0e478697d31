#include "glare/picture/srgb_encoding.h"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "glare/picture/srgb_encoding.cpp"
#include <hwy/foreach_target.h>  // Compiles this file again for each instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glare {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The power 1 / 2.4 of v is the power 5/3 of v^(1/4), which a polynomial follows: of the least
/// largest error, 1.4e-6, from 0.0031308^(1/4) to 1 (Remez).
template <typename Tag>
HWY_INLINE hn::Vec<Tag> encoded(Tag d, hn::Vec<Tag> v) {
  const auto s = hn::Sqrt(hn::Sqrt(v));
  auto power = hn::Set(d, 0.0682079792f);
  for (const float c :
       {-0.318415999f, 0.657188296f, -0.852957428f, 1.36592102f, 0.139604136f, -0.0595466085f})
    power = hn::MulAdd(power, s, hn::Set(d, c));
  const auto straight = hn::Mul(v, hn::Set(d, 12.92f));
  return hn::IfThenElse(hn::Lt(v, hn::Set(d, 0.0031308f)), straight,
                        hn::Min(power, hn::Set(d, 1.0f)));
}

void encode(float* values, std::size_t count) {
  const hn::ScalableTag<float> d;
  const hn::CappedTag<float, 1> one;
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d))
    hn::StoreU(encoded(d, hn::LoadU(d, values + i)), d, values + i);
  for (; i < count; ++i) hn::StoreU(encoded(one, hn::LoadU(one, values + i)), one, values + i);
}

}  // namespace HWY_NAMESPACE
}  // namespace glare
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glare {

HWY_EXPORT(encode);

void encode_srgb(std::span<float> values) {
  HWY_DYNAMIC_DISPATCH(encode)(values.data(), values.size());
}

}  // namespace glare

#endif
