// How one side of a picture is cut into blocks that are convolved by transforms. Internal.
#pragma once

#include <algorithm>

namespace glare {

/// Places along a side: `first` to `end - 1`.
struct Interval {
  int first = 0;
  int end = 0;
  int size() const { return end - first; }
};

/// A kernel's side: light goes from c to c - before ... c + after.
struct KernelReach {
  int before = 0;
  int after = 0;
  int size() const { return before + 1 + after; }
};

/// A side of a picture in blocks (overlap-save): what a block gives, the light that it needs for it
/// and the transform's length at which nothing wraps around into it.
struct AxisBlocks {
  int size = 1;
  int block = 1;  ///< Values that a block gives; the last one may give fewer.
  KernelReach reach;
  bool extends = false;  ///< Light comes from beyond the ends too.

  int count() const { return (size + block - 1) / block; }
  Interval given(int index) const { return {index * block, std::min(size, (index + 1) * block)}; }
  Interval needed(int index) const {
    const Interval out = given(index), in{out.first - reach.after, out.end + reach.before};
    return extends ? in : Interval{std::max(0, in.first), std::min(size, in.end)};
  }
  /// The most that any block needs.
  int largest_needed() const {
    const int all = std::min(block, size) + reach.before + reach.after;
    return extends ? all : std::min(all, size);
  }
  /// With light from c at its place in `needed`, an offset d of -before to after must not meet
  /// another one at the transform's length: both c + d - length and c + d + length lie outside.
  int shortest_transform() const {
    int length = reach.size();
    for (int i = 0; i < count(); ++i) {
      const Interval in = needed(i), out = given(i);
      length =
          std::max({length, out.end - in.first + reach.before, in.end - out.first + reach.after});
    }
    return length;
  }
};

}  // namespace glare
