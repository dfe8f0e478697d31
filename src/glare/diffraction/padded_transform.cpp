#include "glare/diffraction/padded_transform.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace glare {

namespace {

using Complex = std::complex<float>;

/// The values of a quarter, with room so that the next begins aligned, and not in the same place of
/// the cache.
std::size_t part_stride(int quarter) {
  constexpr std::size_t kLine = FourierTransform::kAlignment / sizeof(Complex);
  return (static_cast<std::size_t>(quarter) / kLine + 2) * kLine;
}

/// Complex numbers as their real and imaginary parts: compilers make vector code of that.
float* parts_of(Complex* values) { return reinterpret_cast<float*>(values); }
const float* parts_of(const Complex* values) { return reinterpret_cast<const float*>(values); }

struct Turned {
  float re, im;
};

Turned product(Turned a, const float* turn) {
  return {a.re * turn[0] - a.im * turn[1], a.re * turn[1] + a.im * turn[0]};
}

/// y_r for all r, of a quarter of `n` values; `Quarters` of them are in x.
template <int Quarters>
void turn(const float* __restrict x, std::size_t n, const float* __restrict turns,
          const std::array<float*, 4>& y) {
  float* __restrict y0 = y[0], * __restrict y1 = y[1], * __restrict y2 = y[2], * __restrict y3 = y[3];
  const float *turn1 = turns, *turn2 = turns + 2 * n, *turn3 = turns + 4 * n;
  for (std::size_t i = 0; i < 2 * n; i += 2) {
    Turned a{x[i], x[i + 1]}, b{0, 0}, c{0, 0}, d{0, 0};
    if constexpr (Quarters > 1) b = {x[i + 2 * n], x[i + 2 * n + 1]};
    if constexpr (Quarters > 2) c = {x[i + 4 * n], x[i + 4 * n + 1]};
    if constexpr (Quarters > 3) d = {x[i + 6 * n], x[i + 6 * n + 1]};
    const Turned even{a.re + c.re, a.im + c.im}, odd{a.re - c.re, a.im - c.im};
    const Turned sum{b.re + d.re, b.im + d.im}, difference{b.re - d.re, b.im - d.im};
    const Turned z1 = product({odd.re + difference.im, odd.im - difference.re}, turn1 + i);
    const Turned z2 = product({even.re - sum.re, even.im - sum.im}, turn2 + i);
    const Turned z3 = product({odd.re - difference.im, odd.im + difference.re}, turn3 + i);
    y0[i] = even.re + sum.re;
    y0[i + 1] = even.im + sum.im;
    y1[i] = z1.re;
    y1[i + 1] = z1.im;
    y2[i] = z2.re;
    y2[i + 1] = z2.im;
    y3[i] = z3.re;
    y3[i + 1] = z3.im;
  }
}

}  // namespace

PaddedTransform::PaddedTransform(int samples, int length)
    : quarter_(part_length(length)),
      quarters_((samples + quarter_ - 1) / quarter_),
      transform_(FourierTransform::Kind::complex_to_complex, quarter_) {
  for (int r = 1; r < kParts; ++r)
    for (int n = 0; n < quarter_; ++n)
      turns_.emplace_back(std::polar(1.0, -2 * std::numbers::pi * r * n / length));
}

PaddedTransform::Frequencies PaddedTransform::execute(std::span<const Complex> input,
                                                      Workspace& workspace) const {
  constexpr std::array kTurn = {turn<1>, turn<2>, turn<3>, turn<4>};
  const auto count = static_cast<std::size_t>(quarter_);
  const std::size_t stride = part_stride(quarter_);
  const auto inputs = workspace.inputs.values(kParts * stride);
  const auto frequencies = workspace.frequencies.values(kParts * stride);
  std::array<float*, kParts> turned;
  for (std::size_t r = 0; r < kParts; ++r) turned[r] = parts_of(&inputs[r * stride]);
  kTurn[quarters_ - 1](parts_of(input.data()), count, parts_of(turns_.data()), turned);
  Frequencies result;
  for (std::size_t r = 0; r < kParts; ++r) {
    const auto part = frequencies.subspan(r * stride, count);
    transform_.execute(inputs.subspan(r * stride, count), part);
    result[r] = part.data();
  }
  return result;
}

std::uint64_t PaddedTransform::bytes(int length) {
  const int quarter = part_length(length);
  return (2 * kParts * part_stride(quarter) + (kParts - 1) * static_cast<std::size_t>(quarter)) *
         sizeof(Complex);
}

}  // namespace glare
