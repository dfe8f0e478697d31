#include "glare/convolution/filter_parts.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace glare {

namespace {

constexpr int kColumns = PlaneTransform::kColumns;

/// A kernel's values as they count: those that reach from one pixel of the picture to another; with
/// `extends` those beyond are added to the outermost, because all the light from so far away is the
/// border's.
Image<float> within_picture(const Image<float>& kernel, int width, int height, bool extends) {
  const int left = std::min(kernel.width() / 2, width - 1),
            right = std::min(kernel.width() - 1 - kernel.width() / 2, width - 1),
            up = std::min(kernel.height() / 2, height - 1),
            down = std::min(kernel.height() - 1 - kernel.height() / 2, height - 1);
  Image<double> sums(left + 1 + right, up + 1 + down, 0.0);
  for (int y = 0; y < kernel.height(); ++y) {
    const int dy = y - kernel.height() / 2, near_y = std::clamp(dy, -up, down);
    if (!extends && near_y != dy) continue;
    for (int x = 0; x < kernel.width(); ++x) {
      const int dx = x - kernel.width() / 2, near_x = std::clamp(dx, -left, right);
      if (!extends && near_x != dx) continue;
      sums(near_x + left, near_y + up) += static_cast<double>(kernel(x, y));
    }
  }
  Image<float> result(sums.width(), sums.height());
  std::ranges::transform(sums.values(), result.values().begin(),
                         [](double value) { return static_cast<float>(value); });
  return result;
}

}  // namespace

/// The kernel's spectra, divided by what the transforms there and back multiply by: their lengths,
/// and 2 each for the kernel's and the light's `forward_columns`.
void transform_kernel(GlareFilter::Parts& parts, std::size_t k, int threads) {
  const PlaneTransform& transform = parts.transform;
  const int columns = transform.columns(), rows = transform.rows();
  const BlockPlan& plan = parts.plan;
  Image<float> kernel = within_picture(parts.kernel.channels[k], parts.width, parts.height,
                                       parts.edge == Edge::extend);
  float& center = kernel(plan.across.reach.before, plan.down.reach.before);
  parts.center[k] = std::exchange(center, 0.0f);
  parts.least[k] = std::ranges::all_of(kernel.values(), [](float value) { return value >= 0; })
                       ? 0
                       : -std::numeric_limits<float>::infinity();
  const float scale =
      static_cast<float>(0.25 / (static_cast<double>(columns) * static_cast<double>(rows)));
  const int wide = whole_lines(columns);
  auto& result = parts.spectra[k];
  result.resize(transform.spectra_size(wide));
  parallel_for(wide / kColumns, threads, [&](int part) {
    const auto memory = parts.thread_memory.take();
    const std::span<float> input = transform.column_input(memory->workspaces[0]);
    std::ranges::fill(input, 0.0f);
    for (int y = 0; y < kernel.height(); ++y)
      for (int j = 0; j < kColumns; ++j) {
        int x = part * kColumns + j;
        if (x >= columns) continue;
        if (x > plan.across.reach.after) x -= columns;
        if (x < -plan.across.reach.before || x > plan.across.reach.after) continue;
        const int line = (y - plan.down.reach.before + rows) % rows;
        input[static_cast<std::size_t>(line * kColumns + j)] =
            scale * kernel(x + plan.across.reach.before, y);
      }
    transform.forward_columns(memory->workspaces[0], part * kColumns, wide, result.data());
  });
  parallel_for(transform.groups(), threads, [&](int group) {
    const auto memory = parts.thread_memory.take();
    transform.forward_group(memory->workspaces[0],
                            result.data() + transform.group_start(group, wide));
  });
}

}  // namespace glare
