// Progress and cancellation of long work.
#pragma once

#include <functional>

namespace glare {

/// Called now and then, from one thread at a time, with the share of the work done (0 to 1).
/// Return false to stop: the work then throws `Cancelled`. An empty callback is allowed.
using ProgressCallback = std::function<bool(double fraction_done)>;

/// The callback for a part of some work, which runs from the share `from` of the whole to `to`.
inline ProgressCallback progress_part(const ProgressCallback& whole, double from, double to) {
  if (!whole) return {};
  return [whole, from, to](double fraction) { return whole(from + fraction * (to - from)); };
}

}  // namespace glare
