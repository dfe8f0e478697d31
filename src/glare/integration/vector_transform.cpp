#include "glare/integration/vector_transform.h"

#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "glare/integration/vector_transform.cpp"
#include <hwy/foreach_target.h>  // Compiles this file again for each instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glare {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Complex values, real and imaginary parts in turn, of a row of a block.
using Complex = hn::CappedTag<float, kRaysPerBlock>;
#if HWY_TARGET == HWY_SCALAR
/// One value, since a vector holds but half of it.
struct ComplexVector {
  float real, imaginary;
};
constexpr std::size_t kComplexStep = 2;
HWY_INLINE ComplexVector load(const float* p) { return {p[0], p[1]}; }
HWY_INLINE void store(ComplexVector v, float* p) { p[0] = v.real, p[1] = v.imaginary; }
HWY_INLINE ComplexVector add(ComplexVector a, ComplexVector b) {
  return {a.real + b.real, a.imaginary + b.imaginary};
}
HWY_INLINE ComplexVector subtract(ComplexVector a, ComplexVector b) {
  return {a.real - b.real, a.imaginary - b.imaginary};
}
HWY_INLINE ComplexVector add_scaled(ComplexVector a, float scale, ComplexVector b) {
  return {a.real + scale * b.real, a.imaginary + scale * b.imaginary};
}
HWY_INLINE ComplexVector turned(ComplexVector v, std::complex<float> by) {
  return {by.real() * v.real - by.imag() * v.imaginary,
          by.real() * v.imaginary + by.imag() * v.real};
}
HWY_INLINE ComplexVector quarter_turned(ComplexVector v, float sign) {
  return {-sign * v.imaginary, sign * v.real};
}
#else
using ComplexVector = hn::Vec<Complex>;
constexpr std::size_t kComplexStep = hn::MaxLanes(Complex());
HWY_INLINE ComplexVector load(const float* p) { return hn::Load(Complex(), p); }
HWY_INLINE void store(ComplexVector v, float* p) { hn::Store(v, Complex(), p); }
HWY_INLINE ComplexVector add(ComplexVector a, ComplexVector b) { return hn::Add(a, b); }
HWY_INLINE ComplexVector subtract(ComplexVector a, ComplexVector b) { return hn::Sub(a, b); }
HWY_INLINE ComplexVector add_scaled(ComplexVector a, float scale, ComplexVector b) {
  return hn::MulAdd(hn::Set(Complex(), scale), b, a);
}
/// Times a complex factor.
HWY_INLINE ComplexVector turned(ComplexVector v, std::complex<float> by) {
  const Complex d;
  const auto imaginary = hn::OddEven(hn::Set(d, by.imag()), hn::Set(d, -by.imag()));
  return hn::MulAdd(hn::Set(d, by.real()), v, hn::Mul(imaginary, hn::Shuffle2301(v)));
}
/// Times i (sign 1) or -i (sign -1).
HWY_INLINE ComplexVector quarter_turned(ComplexVector v, float sign) {
  const Complex d;
  return hn::Mul(hn::OddEven(hn::Set(d, sign), hn::Set(d, -sign)), hn::Shuffle2301(v));
}
#endif

/// The transform of a few values, with exp(sign i ...).
HWY_INLINE void butterfly(std::array<ComplexVector, 2>& v, float) {
  const auto sum = add(v[0], v[1]);
  v[1] = subtract(v[0], v[1]);
  v[0] = sum;
}

HWY_INLINE void butterfly(std::array<ComplexVector, 3>& v, float sign) {
  constexpr float kSine = 0.866025403784438647f;  // Of 120 degrees.
  const auto sum = add(v[1], v[2]);
  const auto turn = quarter_turned(subtract(v[1], v[2]), sign * kSine);
  const auto middle = add_scaled(v[0], -0.5f, sum);
  v[0] = add(v[0], sum);
  v[1] = add(middle, turn);
  v[2] = subtract(middle, turn);
}

HWY_INLINE void butterfly(std::array<ComplexVector, 4>& v, float sign) {
  const auto a = add(v[0], v[2]), b = subtract(v[0], v[2]);
  const auto c = add(v[1], v[3]), d = quarter_turned(subtract(v[1], v[3]), sign);
  v = {add(a, c), add(b, d), subtract(a, c), subtract(b, d)};
}

HWY_INLINE void butterfly(std::array<ComplexVector, 5>& v, float sign) {
  constexpr float kCosine1 = 0.309016994374947424f, kCosine2 = -0.809016994374947424f;
  constexpr float kSine1 = 0.951056516295153572f, kSine2 = 0.587785252292473129f;
  const auto sum1 = add(v[1], v[4]), sum2 = add(v[2], v[3]);
  const auto turn1 = quarter_turned(subtract(v[1], v[4]), sign);
  const auto turn2 = quarter_turned(subtract(v[2], v[3]), sign);
  const auto middle1 = add_scaled(add_scaled(v[0], kCosine1, sum1), kCosine2, sum2);
  const auto middle2 = add_scaled(add_scaled(v[0], kCosine2, sum1), kCosine1, sum2);
  const auto zero = subtract(v[0], v[0]);
  const auto side1 = add_scaled(add_scaled(zero, kSine1, turn1), kSine2, turn2);
  const auto side2 = add_scaled(add_scaled(zero, kSine2, turn1), -kSine1, turn2);
  v = {add(v[0], add(sum1, sum2)), add(middle1, side1), add(middle2, side2),
       subtract(middle2, side2), subtract(middle1, side1)};
}

template <std::size_t kRadix>
void RunPass(const TransformPass& pass, const float* input, std::size_t stride, float* output) {
  const float sign = pass.backward ? 1 : -1;
  const auto groups = static_cast<std::size_t>(pass.groups);
  const std::size_t apart = static_cast<std::size_t>(pass.runs) * groups * stride;
  for (int p = 0; p < pass.runs; ++p) {
    const std::complex<float>* const turns =
        pass.turns + static_cast<std::size_t>(p) * (kRadix - 1);
    const float* in = input + static_cast<std::size_t>(p) * groups * stride;
    float* out = output + static_cast<std::size_t>(p) * groups * kRadix * kRaysPerBlock;
    for (std::size_t q = 0; q < groups; ++q, in += stride, out += kRaysPerBlock)
      for (std::size_t lane = 0; lane < kRaysPerBlock; lane += kComplexStep) {
        std::array<ComplexVector, kRadix> v;
        for (std::size_t k = 0; k < kRadix; ++k) v[k] = load(in + k * apart + lane);
        butterfly(v, sign);
        store(v[0], out + lane);
        for (std::size_t j = 1; j < kRadix; ++j)
          store(turned(v[j], turns[j - 1]), out + j * groups * kRaysPerBlock + lane);
      }
  }
}

void RunTransformPass(const TransformPass& pass, const float* input, std::size_t stride,
                      float* output) {
  switch (pass.radix) {
    case 2:
      return RunPass<2>(pass, input, stride, output);
    case 3:
      return RunPass<3>(pass, input, stride, output);
    case 4:
      return RunPass<4>(pass, input, stride, output);
    default:
      return RunPass<5>(pass, input, stride, output);
  }
}

void MultiplyRows(std::span<const std::complex<float>> factors, const float* rows, float* result) {
  for (const std::complex<float>& factor : factors) {
    for (std::size_t lane = 0; lane < kRaysPerBlock; lane += kComplexStep)
      store(turned(load(rows + lane), factor), result + lane);
    rows += kRaysPerBlock;
    result += kRaysPerBlock;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace glare
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glare {

HWY_EXPORT(MultiplyRows);
HWY_EXPORT(RunTransformPass);

void multiply_rows(std::span<const std::complex<float>> factors, const std::complex<float>* rows,
                   std::complex<float>* result) {
  HWY_DYNAMIC_DISPATCH(MultiplyRows)
  (factors, reinterpret_cast<const float*>(rows), reinterpret_cast<float*>(result));
}

void transform_pass(const TransformPass& pass, const std::complex<float>* input, std::size_t stride,
                    std::complex<float>* output) {
  HWY_DYNAMIC_DISPATCH(RunTransformPass)
  (pass, reinterpret_cast<const float*>(input), 2 * stride, reinterpret_cast<float*>(output));
}

}  // namespace glare

#endif  // HWY_ONCE
