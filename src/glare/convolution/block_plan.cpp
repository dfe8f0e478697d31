#include "glare/convolution/block_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "glare/base/error.h"
#include "glare/convolution/plane_transform.h"

namespace glare {

namespace {

constexpr int kMostBlocks = 256;  ///< Along a side.

/// Light that is held is moved once more, and the passes over it begin anew for each block: 1080p
/// and 2160p with kernels of 9 to 513 pixels took 1.0 to 2.7 times as long as whole.
constexpr double kBlocksCost = 3;

/// In butterflies' work: the transforms' passes, and one more for moving values around.
double cost(const BlockPlan& plan) {
  const auto work = [](double count, int length) {
    return count * length * (std::log2(length) + 3);
  };
  const double frequencies = plan.rows / 2 + 1;
  double sum = 0;
  for (int i = 0; i < plan.across.count(); ++i) {
    const double in = whole_lines(plan.across.needed(i).size()),
                 out = whole_lines(plan.across.given(i).size());
    sum += work((in + out) / 2, plan.rows) + work(2 * frequencies, plan.columns);
  }
  return sum * plan.down.count() * (plan.is_whole() ? 1 : kBlocksCost);
}

AxisBlocks blocks(int size, int count, const KernelReach& reach, bool extends) {
  const int block = (size + count - 1) / count;
  return {size, block, reach, extends};
}

/// Blocks that are small beside the kernel would take hours and save little.
bool is_too_small(const AxisBlocks& axis) {
  return axis.count() > 1 && axis.block < std::max(PlaneTransform::kColumns, axis.reach.size() / 8);
}

}  // namespace

int whole_lines(int columns) {
  constexpr int n = PlaneTransform::kColumns;
  return (columns + n - 1) / n * n;
}

int BlockPlan::held_columns() const { return is_whole() ? 0 : across.block + across.reach.after; }

std::uint64_t BlockPlan::kernel_bytes() const {
  const auto groups = static_cast<std::uint64_t>(rows / 2 / PlaneTransform::kLine + 1);
  return 3 * groups * static_cast<std::uint64_t>(whole_lines(columns)) * 64;
}

std::uint64_t BlockPlan::call_bytes(int threads) const {
  const auto groups = static_cast<std::uint64_t>(rows / 2 / PlaneTransform::kLine + 1);
  const auto lines = static_cast<std::uint64_t>(whole_lines(across.largest_needed()));
  const auto held =
      static_cast<std::uint64_t>(held_columns()) * static_cast<std::uint64_t>(down.size);
  return 3 * (groups * lines * 64 + held * sizeof(float)) +
         static_cast<std::uint64_t>(threads) * 3 * PlaneTransform::workspace_bytes(columns, rows);
}

BlockPlan quickest_blocks(const ConvolutionSize& size, std::uint64_t limit_bytes,
                          std::uint64_t other_bytes) {
  std::optional<BlockPlan> best;
  double least = 0;
  // The kernel as it counts for the picture, while its spectra are made: in double and in float.
  const std::uint64_t making_bytes = (sizeof(double) + sizeof(float)) *
                                     static_cast<std::uint64_t>(size.across.size()) *
                                     static_cast<std::uint64_t>(size.down.size());
  std::uint64_t fewest_bytes = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t limit = limit_bytes == 0 ? fewest_bytes : limit_bytes;
  for (int nx = 1; nx <= std::min(size.width, kMostBlocks); ++nx)
    for (int ny = 1; ny <= std::min(size.height, kMostBlocks); ++ny) {
      BlockPlan plan{blocks(size.width, nx, size.across, size.extends),
                     blocks(size.height, ny, size.down, size.extends)};
      if (plan.across.count() != nx || plan.down.count() != ny) continue;
      if (is_too_small(plan.across) || is_too_small(plan.down)) continue;
      plan.columns = BlockTransform::length_for(plan.across.shortest_transform());
      plan.rows = BlockTransform::length_for(plan.down.shortest_transform());
      const std::uint64_t bytes =
          other_bytes + plan.kernel_bytes() + std::max(making_bytes, plan.call_bytes(size.threads));
      fewest_bytes = std::min(fewest_bytes, bytes);
      if (bytes > limit || (best && cost(plan) >= least)) continue;
      best = plan;
      least = cost(plan);
    }
  if (!best) throw MemoryError(fewest_bytes, limit_bytes);
  return *best;
}

}  // namespace glare
