// One call of `apply_glare`: light is taken, transformed, multiplied by the kernel's spectra,
// transformed back and added, block by block.
#include <algorithm>
#include <atomic>
#include <string>

#include "glare/base/error.h"
#include "glare/base/parallel.h"
#include "glare/base/range_check.h"
#include "glare/convolution/filter_parts.h"
#include "glare/convolution/light_loops.h"

namespace glare {

namespace {

using Complex = PlaneTransform::Complex;
constexpr int kColumns = PlaneTransform::kColumns;
constexpr int kBeyond = 1 << 30;  ///< Any picture and kernel.

/// Light is transformed times this, a power of two, so that sums of the largest floats stay finite.
constexpr float kLightScale = 0x1p-32f;

ChannelLines<float> lines(std::array<Image<float>, 3>& channels, int x, int y) {
  ChannelLines<float> result{{}, static_cast<std::size_t>(channels[0].width())};
  for (std::size_t k = 0; k < 3; ++k) result.channels[k] = channels[k].row(y).data() + x;
  return result;
}

ChannelLines<float> moved(ChannelLines<float> lines, int columns) {
  for (float*& channel : lines.channels) channel += columns;
  return lines;
}

ChannelLines<const float> constant(const ChannelLines<float>& lines) {
  return {{lines.channels[0], lines.channels[1], lines.channels[2]}, lines.stride};
}

GlareSum glare_sum(const GlareFilter::Parts& parts, const ApplyGlareOptions& options) {
  GlareSum sum{
      kLightScale, static_cast<float>(options.strength), options.only_glare, {}, parts.least};
  for (std::size_t k = 0; k < 3; ++k)
    sum.own[k] =
        static_cast<float>(static_cast<double>(parts.center[k]) + parts.kernel.kept[k] - 1);
  return sum;
}

/// One call of `apply_glare`.
class Application {
 public:
  Application(Picture& picture, const GlareFilter::Parts& parts, const ApplyGlareOptions& options)
      : picture_(picture),
        parts_(parts),
        options_(options),
        curve_(bright_curve(parts.kernel.color_space, options.bright)),
        sum_(glare_sum(parts, options)),
        memory_(parts.call_memory.take()) {
    const int most_columns = whole_lines(parts.plan.across.largest_needed());
    for (auto& spectra : memory_->spectra)  // At once, so that no two are there while they grow.
      spectra.values(parts.transform.spectra_size(most_columns));
    for (auto& held : memory_->held)
      if (!parts.plan.is_whole() && held.empty())
        held = Image<float>::uninitialized(parts.plan.held_columns(), parts.height);
  }

  UnusablePixels run() {
    const int blocks = parts_.plan.across.count() * parts_.plan.down.count();
    for (int i = 0, done = 0; i < parts_.plan.across.count(); ++i) {
      if (!parts_.plan.is_whole()) hold_columns(i);
      for (int j = 0; j < parts_.plan.down.count(); ++j, ++done)
        convolve_block(i, j,
                       progress_part(options_.progress, static_cast<double>(done) / blocks,
                                     static_cast<double>(done + 1) / blocks));
    }
    return {nan_, infinite_, negative_};
  }

 private:
  ChannelLines<float> pixels(int x, int y) const { return lines(picture_.channels, x, y); }

  void count(const UnusablePixels& some) {
    if (some.total() == 0) return;
    nan_ += some.nan;
    infinite_ += some.infinite;
    negative_ += some.negative;
  }

  /// Holds the light of the columns that these blocks give, behind the last ones of those before.
  void hold_columns(int i) {
    const Interval given = parts_.plan.across.given(i);
    const int before = parts_.plan.across.reach.after, step = parts_.plan.across.block;
    parallel_for(parts_.height, options_.threads, [&](int y) {
      for (auto& held : memory_->held) {
        float* const row = held.row(y).data();
        if (i > 0) std::copy(row + step, row + step + before, row);
      }
      count(take_light(curve_, constant(pixels(given.first, y)), 1,
                       static_cast<std::size_t>(given.size()), kLightScale,
                       lines(memory_->held, before, y)));
    });
    held_first_ = given.first - before;
    held_end_ = given.end == parts_.width ? kBeyond : given.end;
  }

  void convolve_block(int i, int j, const ProgressCallback& progress) {
    const Interval in = parts_.plan.across.needed(i), out = parts_.plan.across.given(i);
    const PlaneTransform& transform = parts_.transform;
    const int columns = whole_lines(in.size());
    parallel_for(
        columns / kColumns, options_.threads,
        [&](int part) { transform_columns(i, j, part * kColumns, columns); },
        progress_part(progress, 0, 0.3));
    parallel_for(
        3 * transform.groups(), options_.threads,
        [&](int task) {
          const auto k = static_cast<std::size_t>(task % 3);
          convolve_group(k, task / 3, columns, in, out);
        },
        progress_part(progress, 0.3, 0.7));
    parallel_for((out.size() + kColumns - 1) / kColumns, options_.threads,
                 [&](int part) { add_columns(i, j, part * kColumns, columns); },
                 progress_part(progress, 0.7, 1));
  }

  Complex* spectra(std::size_t k, int columns) const {
    return memory_->spectra[k].values(parts_.transform.spectra_size(columns)).data();
  }

  /// The spectra of sixteen columns of light.
  void transform_columns(int i, int j, int first, int columns) {
    const auto memory = parts_.thread_memory.take();
    const PlaneTransform& transform = parts_.transform;
    const Interval in_x = parts_.plan.across.needed(i), in_y = parts_.plan.down.needed(j);
    const int x = in_x.first + first, used = std::min(kColumns, in_x.end - x);
    const int above = std::max(0, -in_y.first), inside_end = std::min(parts_.height, in_y.end);
    std::array<std::span<float>, 3> inputs;
    ChannelLines<float> inside{{}, kColumns};
    for (std::size_t k = 0; k < 3; ++k) {
      inputs[k] = transform.column_input(memory->workspaces[k]);
      inside.channels[k] = inputs[k].data() + above * kColumns;
    }
    load_lines(x, used, {in_y.first + above, inside_end}, inside);
    for (std::size_t k = 0; k < 3; ++k) {
      extend_lines(inputs[k], above, inside_end - in_y.first, in_y.size());
      transform.forward_columns(memory->workspaces[k], first, columns, spectra(k, columns));
    }
  }

  /// Lines before `first` become as that, those from `last` to `end` - 1 as that before it, and all
  /// others zero.
  static void extend_lines(std::span<float> lines, int first, int last, int end) {
    const auto line = [&](int y) {
      return lines.subspan(static_cast<std::size_t>(y) * kColumns, kColumns);
    };
    for (int y = 0; y < first; ++y) std::ranges::copy(line(first), line(y).begin());
    for (int y = last; y < end; ++y) std::ranges::copy(line(last - 1), line(y).begin());
    std::ranges::fill(lines.subspan(static_cast<std::size_t>(end) * kColumns), 0.0f);
  }

  /// The light of columns `x` to `x + used` - 1 of rows of the picture, those beyond its sides
  /// being as these, and zeros to a whole line.
  void load_lines(int x, int used, const Interval& rows, const ChannelLines<float>& result) {
    const bool is_whole = parts_.plan.is_whole(), is_inside = is_full(x, used);
    const int held = is_whole ? 0 : std::clamp(held_end_ - x, 0, used);
    const auto take = [&](const ChannelLines<float>& from, int first, int last) {
      return take_light(curve_, constant(from), static_cast<std::size_t>(rows.size()),
                        static_cast<std::size_t>(last - first), kLightScale, moved(result, first));
    };
    if (is_inside && held == 0) {
      const UnusablePixels some = take(pixels(x, rows.first), 0, kColumns);
      return is_whole ? count(some) : void();
    }
    for (int y = rows.first; y < rows.end; ++y)
      for (std::size_t k = 0; k < 3; ++k)
        copy_columns(k, x, y, held, used, result.channels[k] + (y - rows.first) * kColumns);
    const int begin = std::clamp(-x, held, used), end = std::clamp(parts_.width - x, begin, used);
    take(moved(result, held), held, begin);
    const UnusablePixels some = take(moved(result, begin), begin, end);
    if (is_whole) count(some);
    take(moved(result, end), end, used);
  }

  bool is_full(int x, int used) const {
    return used == kColumns && x >= 0 && x + kColumns <= parts_.width;
  }

  /// To a line: `from_held` columns of light that is held, then pixels, then zeros.
  void copy_columns(std::size_t k, int x, int y, int from_held, int used, float* line) const {
    if (from_held == kColumns && is_full(x, used)) {
      std::copy_n(memory_->held[k].row(y).data() + (x - held_first_), kColumns, line);
      return;
    }
    for (int c = 0; c < kColumns; ++c) {
      const int near_x = std::clamp(x + c, 0, parts_.width - 1);
      line[c] = c >= used       ? 0.0f
                : c < from_held ? memory_->held[k](near_x - held_first_, y)
                                : picture_.channels[k](near_x, y);
    }
  }

  void convolve_group(std::size_t k, int group, int columns, const Interval& in,
                      const Interval& out) {
    const auto memory = parts_.thread_memory.take();
    const PlaneTransform& transform = parts_.transform;
    const Complex* const kernel =
        parts_.spectra[k].data() + transform.group_start(group, whole_lines(transform.columns()));
    transform.convolve_group(memory->workspaces[0],
                             spectra(k, columns) + transform.group_start(group, columns), in.size(),
                             kernel, out.first - in.first, out.size());
  }

  /// The result in sixteen columns.
  void add_columns(int i, int j, int first, int columns) {
    const auto memory = parts_.thread_memory.take();
    const Interval in_y = parts_.plan.down.needed(j), out_y = parts_.plan.down.given(j);
    const Interval out_x = parts_.plan.across.given(i);
    ChannelLines<const float> spread{{}, kColumns};
    for (std::size_t k = 0; k < 3; ++k)
      spread.channels[k] =
          parts_.transform
              .backward_columns(memory->workspaces[k], first, columns, spectra(k, columns))
              .data() +
          (out_y.first - in_y.first) * kColumns;
    const int x = out_x.first + first, used = std::min(kColumns, out_x.end - x);
    add_glare(curve_, sum_, spread, static_cast<std::size_t>(out_y.size()),
              static_cast<std::size_t>(used), pixels(x, out_y.first));
  }

  Picture& picture_;
  const GlareFilter::Parts& parts_;
  const ApplyGlareOptions& options_;
  BrightCurve curve_;
  GlareSum sum_;
  decltype(parts_.call_memory.take()) memory_;
  int held_first_ = 0, held_end_ = 0;  ///< Columns that are held.
  std::atomic<std::uint64_t> nan_{0}, infinite_{0}, negative_{0};
};

}  // namespace

UnusablePixels apply_glare(Picture& picture, const GlareFilter& filter,
                           const ApplyGlareOptions& options) {
  require_in_range("the glare's strength", options.strength, 0, 1000);
  for (const auto& channel : picture.channels)
    if (channel.width() != filter.width() || channel.height() != filter.height())
      throw OptionError("the picture is " + std::to_string(channel.width()) + " x " +
                        std::to_string(channel.height()) + " pixels, expected " +
                        std::to_string(filter.width()) + " x " + std::to_string(filter.height()) +
                        " as the glare's filter");
  return Application(picture, filter.parts(), options).run();
}

}  // namespace glare
