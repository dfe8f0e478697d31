#include "glare/convolution/spectrum_loops.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "glare/convolution/spectrum_loops.cpp"
#include <hwy/foreach_target.h>  // Compiles this file again for each instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glare {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kLine = 8;  ///< Complex values of a line of memory.

#if HWY_TARGET == HWY_SCALAR
/// Two complex values.
struct Pair {
  float v[4];
};
HWY_INLINE Pair load(const float* p) { return {{p[0], p[1], p[2], p[3]}}; }
HWY_INLINE void store(const Pair& a, float* p) {
  for (int i = 0; i < 4; ++i) p[i] = a.v[i];
}
HWY_INLINE Pair add(const Pair& a, const Pair& b) {
  return {{a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2], a.v[3] + b.v[3]}};
}
HWY_INLINE Pair subtract(const Pair& a, const Pair& b) {
  return {{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2], a.v[3] - b.v[3]}};
}
HWY_INLINE Pair conjugate(const Pair& a) { return {{a.v[0], -a.v[1], a.v[2], -a.v[3]}}; }
HWY_INLINE Pair swapped(const Pair& a) { return {{a.v[1], a.v[0], a.v[3], a.v[2]}}; }
HWY_INLINE Pair firsts(const Pair& a, const Pair& b) { return {{a.v[0], a.v[1], b.v[0], b.v[1]}}; }
HWY_INLINE Pair seconds(const Pair& a, const Pair& b) { return {{a.v[2], a.v[3], b.v[2], b.v[3]}}; }
void Multiply(float* values, const float* factors, std::size_t count) {
  for (std::size_t i = 0; i < 2 * count; i += 2) {
    const float real = values[i] * factors[i] - values[i + 1] * factors[i + 1];
    values[i + 1] = values[i] * factors[i + 1] + values[i + 1] * factors[i];
    values[i] = real;
  }
}
#else
/// Two complex values.
using Four = hn::CappedTag<float, 4>;
using Two = hn::CappedTag<double, 2>;
using Pair = hn::Vec<Four>;
HWY_INLINE Pair load(const float* p) { return hn::Load(Four(), p); }
HWY_INLINE void store(Pair a, float* p) { hn::Store(a, Four(), p); }
HWY_INLINE Pair add(Pair a, Pair b) { return hn::Add(a, b); }
HWY_INLINE Pair subtract(Pair a, Pair b) { return hn::Sub(a, b); }
HWY_INLINE Pair conjugate(Pair a) { return hn::OddEven(hn::Neg(a), a); }
HWY_INLINE Pair swapped(Pair a) { return hn::Shuffle2301(a); }
/// The first values of both, and the second ones.
HWY_INLINE Pair firsts(Pair a, Pair b) {
  return hn::BitCast(Four(),
                     hn::InterleaveLower(Two(), hn::BitCast(Two(), a), hn::BitCast(Two(), b)));
}
HWY_INLINE Pair seconds(Pair a, Pair b) {
  return hn::BitCast(Four(),
                     hn::InterleaveUpper(Two(), hn::BitCast(Two(), a), hn::BitCast(Two(), b)));
}
void Multiply(float* values, const float* factors, std::size_t count) {
  const hn::CappedTag<float, 2 * kLine> d;
  for (std::size_t i = 0; i < 2 * count; i += hn::Lanes(d)) {
    const auto value = hn::Load(d, values + i), factor = hn::Load(d, factors + i);
    const auto swapped_value = hn::Shuffle2301(value), real = hn::DupEven(factor),
               cross = hn::Mul(swapped_value, hn::DupOdd(factor));
    hn::Store(hn::OddEven(hn::MulAdd(value, real, cross), hn::MulSub(value, real, cross)), d,
              values + i);
  }
}
#endif

/// Line k of a block, and the one of frequency -k.
HWY_INLINE std::size_t Line(std::size_t k, std::size_t length) { return k % length * 2 * kLine; }
HWY_INLINE std::size_t Opposite(std::size_t k, std::size_t length) {
  return (length - k % length) % length * 2 * kLine;
}

void TakeColumnsApart(const float* block, std::size_t length, std::size_t group_stride,
                      float* spectra) {
  for (std::size_t group = 0; group <= length / 2 / kLine; ++group, spectra += group_stride)
    for (std::size_t f = 0; f < kLine; f += 2) {
      const std::size_t k = group * kLine + f;
      const float *const k0 = block + Line(k, length), *const k1 = block + Line(k + 1, length);
      const float *const m0 = block + Opposite(k, length), *const m1 =
                                                               block + Opposite(k + 1, length);
      for (std::size_t j = 0; j < kLine; j += 2) {  // Two frequencies of two signals.
        const auto at0 = load(k0 + 2 * j), opposite0 = conjugate(load(m0 + 2 * j));
        const auto at1 = load(k1 + 2 * j), opposite1 = conjugate(load(m1 + 2 * j));
        const auto a0 = add(at0, opposite0), a1 = add(at1, opposite1);
        const auto b0 = conjugate(swapped(subtract(at0, opposite0))),
                   b1 = conjugate(swapped(subtract(at1, opposite1)));
        float* const column = spectra + (2 * j * kLine + f) * 2;
        store(firsts(a0, a1), column);
        store(firsts(b0, b1), column + 2 * kLine);
        store(seconds(a0, a1), column + 4 * kLine);
        store(seconds(b0, b1), column + 6 * kLine);
      }
    }
}

void PutColumnsTogether(const float* spectra, std::size_t group_stride, std::size_t length,
                        float* block) {
  for (std::size_t group = 0; group <= length / 2 / kLine; ++group, spectra += group_stride)
    for (std::size_t f = 0; f < kLine; f += 2) {
      const std::size_t k = group * kLine + f;
      if (k > length / 2) return;
      const bool has_second = k + 1 <= length / 2;
      for (std::size_t j = 0; j < kLine; j += 2) {
        const float* const column = spectra + (2 * j * kLine + f) * 2;
        const auto a0 = load(column), b0 = swapped(load(column + 2 * kLine));
        const auto a1 = load(column + 4 * kLine), b1 = swapped(load(column + 6 * kLine));
        // a + i b, and at the opposite frequency conj(a) + i conj(b).
        const auto at0 = subtract(a0, conjugate(b0)), at1 = subtract(a1, conjugate(b1));
        const auto opposite0 = add(conjugate(a0), b0), opposite1 = add(conjugate(a1), b1);
        store(firsts(at0, at1), block + Line(k, length) + 2 * j);
        store(firsts(opposite0, opposite1), block + Opposite(k, length) + 2 * j);
        if (!has_second) continue;
        store(seconds(at0, at1), block + Line(k + 1, length) + 2 * j);
        store(seconds(opposite0, opposite1), block + Opposite(k + 1, length) + 2 * j);
      }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glare
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glare {

HWY_EXPORT(TakeColumnsApart);
HWY_EXPORT(PutColumnsTogether);
HWY_EXPORT(Multiply);

void take_columns_apart(const std::complex<float>* block, std::size_t length,
                        std::size_t group_stride, std::complex<float>* spectra) {
  HWY_DYNAMIC_DISPATCH(TakeColumnsApart)
  (reinterpret_cast<const float*>(block), length, 2 * group_stride,
   reinterpret_cast<float*>(spectra));
}

void put_columns_together(const std::complex<float>* spectra, std::size_t group_stride,
                          std::size_t length, std::complex<float>* block) {
  HWY_DYNAMIC_DISPATCH(PutColumnsTogether)
  (reinterpret_cast<const float*>(spectra), 2 * group_stride, length,
   reinterpret_cast<float*>(block));
}

void multiply(std::complex<float>* values, const std::complex<float>* factors, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(Multiply)
  (reinterpret_cast<float*>(values), reinterpret_cast<const float*>(factors), count);
}

}  // namespace glare

#endif  // HWY_ONCE
