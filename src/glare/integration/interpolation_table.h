// Interpolation weights by table, laid out for vectors. Internal.
#pragma once

#include <array>
#include <vector>

#include "glare/integration/windowed_sinc.h"

namespace glare {

/// The weights of a kernel of 8 or 12 taps for every fraction of a sample, linear between entries.
template <int kTapCount>
class InterpolationTable {
 public:
  static constexpr int kTaps = kTapCount;
  static constexpr int kLogSteps = 8;
  static constexpr int kSteps = 1 << kLogSteps;  ///< Of a sample; errs by less than 1e-5.

  /// Weights at the beginning of a step, and how they change over the step.
  struct alignas(32) Entry {
    alignas(32) std::array<float, kTaps> weights;
    alignas(32) std::array<float, kTaps> change;
  };

  explicit InterpolationTable(double kaiser_beta);

  const Entry* entries() const { return entries_.data(); }

 private:
  std::vector<Entry> entries_;
};

extern template class InterpolationTable<8>;
extern template class InterpolationTable<12>;

}  // namespace glare
