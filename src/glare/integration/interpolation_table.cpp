#include "glare/integration/interpolation_table.h"

#include <algorithm>

namespace glare {

template <int kTapCount>
InterpolationTable<kTapCount>::InterpolationTable(double kaiser_beta) : entries_(kSteps + 1) {
  const WindowedSinc kernel{kTaps, kaiser_beta};
  auto here = interpolation_weights(kernel, 0);
  for (int i = 0; i <= kSteps; ++i) {
    const auto next = interpolation_weights(kernel, std::min(1.0, (i + 1.0) / kSteps));
    for (int j = 0; j < kTaps; ++j) {
      entries_[i].weights[j] = static_cast<float>(here[j]);
      entries_[i].change[j] = static_cast<float>(next[j] - here[j]);
    }
    here = next;
  }
}

template class InterpolationTable<8>;
template class InterpolationTable<12>;

}  // namespace glare
