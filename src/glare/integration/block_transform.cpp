#include "glare/integration/block_transform.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace glare {

namespace {

/// exp(-2 pi i p j / n).
std::vector<std::complex<float>> turns_of(int n, int radix) {
  std::vector<std::complex<float>> turns;
  for (int p = 0; p < n / radix; ++p)
    for (int j = 1; j < radix; ++j) {
      const double angle = -2 * std::numbers::pi * p * j / n;
      turns.emplace_back(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
    }
  return turns;
}

}  // namespace

BlockTransform::BlockTransform(int length) : length_(length) {
  int rest = length, groups = 1;
  for (const int radix : {4, 2, 3, 5})
    for (; rest % radix == 0; rest /= radix, groups *= radix) {
      Pass pass;
      pass.turns = turns_of(rest, radix);
      for (const auto& turn : pass.turns) pass.turns_back.push_back(std::conj(turn));
      passes_.push_back(std::move(pass));
      passes_.back().forward = {radix, rest / radix, groups, false, passes_.back().turns.data()};
      passes_.back().backward = {radix, rest / radix, groups, true,
                                 passes_.back().turns_back.data()};
    }
  assert(rest == 1 && length >= 2);
}

int BlockTransform::length_for(int minimum) {
  for (int length = std::max(2, minimum + minimum % 2);; length += 2) {
    int rest = length;
    for (const int factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return length;
  }
}

std::span<std::complex<float>> BlockTransform::run(bool backward, const std::complex<float>* input,
                                                   std::size_t stride, Buffer& a, Buffer& b) const {
  const auto count = static_cast<std::size_t>(length_) * kSignals;
  std::span<std::complex<float>> from, to = a.values(count), other = b.values(count);
  for (const Pass& pass : passes_) {
    transform_pass(backward ? pass.backward : pass.forward, from.empty() ? input : from.data(),
                   from.empty() ? stride : kSignals, to.data());
    from = to;
    std::swap(to, other);
  }
  return from;
}

std::span<std::complex<float>> BlockTransform::forward(const std::complex<float>* input,
                                                       std::size_t stride, Buffer& a,
                                                       Buffer& b) const {
  return run(false, input, stride, a, b);
}

std::span<std::complex<float>> BlockTransform::backward(const std::complex<float>* input,
                                                        std::size_t stride, Buffer& a,
                                                        Buffer& b) const {
  return run(true, input, stride, a, b);
}

}  // namespace glare
