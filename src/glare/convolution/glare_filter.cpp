#include "glare/convolution/glare_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "glare/base/error.h"
#include "glare/base/range_check.h"
#include "glare/convolution/filter_parts.h"

namespace glare {

namespace {

constexpr int kLargestSide = 65535;

KernelReach reach_within(int kernel_size, int size) {
  return {std::min(kernel_size / 2, size - 1),
          std::min(kernel_size - 1 - kernel_size / 2, size - 1)};
}

void require_valid(const PixelKernel& kernel, int width, int height) {
  require_in_range("the picture's width", width, 1, kLargestSide);
  require_in_range("the picture's height", height, 1, kLargestSide);
  require_in_range("the kernel's width", kernel.width(), 1, 1 << 20);
  require_in_range("the kernel's height", kernel.height(), 1, 1 << 20);
  for (const auto& channel : kernel.channels) {
    if (channel.width() != kernel.width() || channel.height() != kernel.height())
      throw OptionError("the kernel's channels are not of one size");
    if (!std::ranges::all_of(channel.values(), [](float share) { return std::isfinite(share); }))
      throw OptionError("the kernel has a share that isn't finite");
  }
}

std::uint64_t bytes_of(const PixelKernel& kernel) {
  return 3 * sizeof(float) * static_cast<std::uint64_t>(kernel.width()) *
         static_cast<std::uint64_t>(kernel.height());
}

}  // namespace

GlareFilter::GlareFilter(PixelKernel kernel, int width, int height,
                         const GlareFilterOptions& options) {
  require_valid(kernel, width, height);
  const ConvolutionSize size{width,
                             height,
                             reach_within(kernel.width(), width),
                             reach_within(kernel.height(), height),
                             options.edge == Edge::extend,
                             threads_used(0)};
  const BlockPlan plan = quickest_blocks(size, options.memory_limit_bytes, bytes_of(kernel));
  const std::shared_ptr<Parts> parts(new Parts{std::move(kernel),
                                               width,
                                               height,
                                               options.edge,
                                               plan,
                                               PlaneTransform(plan.columns, plan.rows),
                                               {},
                                               {},
                                               {},
                                               {},
                                               {}});
  for (std::size_t k = 0; k < 3; ++k) transform_kernel(*parts, k, options.threads);
  parts_ = parts;
}

int GlareFilter::width() const { return parts_->width; }
int GlareFilter::height() const { return parts_->height; }
const PixelKernel& GlareFilter::kernel() const { return parts_->kernel; }

}  // namespace glare
