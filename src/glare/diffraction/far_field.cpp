#include "glare/diffraction/far_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <vector>

#include "glare/aperture/open_part.h"
#include "glare/base/parallel.h"
#include "glare/diffraction/padded_transform.h"

namespace glare {

namespace {

using Complex = std::complex<float>;

constexpr int kRowsPerTask = 16;
/// Between the two passes the columns lie in blocks, row by row: a row of a block is a cache line.
constexpr int kColumnsPerBlock = 8;
constexpr std::int64_t kFloatsPerBlockRow = 2 * kColumnsPerBlock;
constexpr int kBlocksPerCopy = 32;

/// Sizes along one axis: transform length, and the samples held.
struct Axis {
  int length = 0;         ///< Of the zero-padded transform: a multiple of 4.
  double bin_per_mm = 0;  ///< Distance between its frequencies.
  int last_k = 0;         ///< The largest frequency index held.

  Axis(int open_samples, double pixel_mm, double max_frequency_per_mm, double padding) {
    constexpr int kShortest = 64;
    const int least = std::max(kShortest, static_cast<int>(std::ceil(padding * open_samples)));
    length = 2 * fast_transform_length((least + 1) / 2);
    bin_per_mm = 1 / (length * pixel_mm);
    last_k = static_cast<int>(std::ceil(max_frequency_per_mm / bin_per_mm)) + kFarFieldMargin;
  }
};

/// The frequencies kx >= 0 that are transformed; the rest follow by symmetry.
int transformed_count(const Axis& axis) { return std::min(axis.last_k, axis.length / 2) + 1; }

/// Rows held on the other side of the axis; they repeat rows that are held anyway.
int overlap_count(const FarFieldRequest& request, const Axis& axis) {
  const double samples = request.overlap_frequency_x_per_mm / axis.bin_per_mm;
  return std::min(axis.last_k, static_cast<int>(std::ceil(samples)) + kFarFieldMargin);
}

/// Blocks of columns that may be transformed at the same time, after a copy of them is made or not.
struct Wave {
  int begin, end;
  bool copied;
};

/// Sizes and places. The intensity has a row for each kx, and a column for each ky. The blocks of
/// columns, which the first pass makes and the second takes, lie at the end of the intensity's own
/// memory where they can: then each is read before the intensity that is written reaches it.
struct Layout {
  Axis x, y;
  int open_height;
  int overlap;  ///< Rows kx < 0.
  int count;    ///< Rows kx >= 0 that are transformed; there may be more.
  int blocks;   ///< Of their columns.
  std::int64_t block_floats;
  std::int64_t width, height;  ///< Of the intensity.
  bool shared = true;          ///< The blocks lie in the intensity's memory.
  std::vector<Wave> waves;

  Layout(int open_width, int open_height_, double pixel_mm, const FarFieldRequest& request)
      : x(open_width, pixel_mm, request.max_frequency_x_per_mm, request.padding),
        y(open_height_, pixel_mm, request.max_frequency_y_per_mm, request.padding),
        open_height(open_height_),
        overlap(overlap_count(request, x)),
        count(transformed_count(x)),
        blocks((count + kColumnsPerBlock - 1) / kColumnsPerBlock),
        block_floats(kFloatsPerBlockRow * open_height),
        width(2 * y.last_k + 1),
        height(overlap + x.last_k + 1) {
    if (plan_waves()) return;
    shared = false;
    waves = {{0, blocks, false}};
  }

  std::int64_t floats() const { return width * height; }
  std::int64_t blocks_floats() const { return blocks * block_floats; }
  std::int64_t copy_floats() const {
    const bool copies = std::ranges::any_of(waves, [](const Wave& wave) { return wave.copied; });
    return copies ? kBlocksPerCopy * block_floats : 0;
  }
  /// Where the blocks begin in the memory they lie in; in the intensity's, on a cache line.
  std::int64_t blocks_start() const {
    return shared ? floats() / kFloatsPerBlockRow * kFloatsPerBlockRow - blocks_floats() : 0;
  }

 private:
  std::int64_t block_start(int block) const { return blocks_start() + block * block_floats; }
  /// Where what is written for the blocks before this one ends.
  std::int64_t written_end(int block) const {
    return (overlap + std::min(block * kColumnsPerBlock, count)) * width;
  }
  bool plan_waves() {
    if (written_end(0) > block_start(0)) return false;
    for (int begin = 0; begin < blocks; begin = waves.back().end) {
      int end = begin;
      while (end < blocks && written_end(end + 1) <= block_start(begin)) ++end;
      const bool copied = end < std::min(begin + kBlocksPerCopy, blocks);
      if (copied) {
        end = std::min(begin + kBlocksPerCopy, blocks);
        while (end > begin && end < blocks && written_end(end) > block_start(end)) --end;
      }
      if (end == begin) return false;
      waves.push_back({begin, end, copied});
    }
    return true;
  }
};

/// One thread's.
struct Workspace {
  GrowingBuffer<Complex> samples;
  PaddedTransform::Workspace transform;
};

std::uint64_t workspace_bytes(const Layout& layout, int threads) {
  const auto used = static_cast<std::uint64_t>(threads_used(threads));
  const int longer = std::max(layout.x.length, layout.y.length);
  const auto gathered = static_cast<std::uint64_t>(longer + kColumnsPerBlock);
  return used * (kColumnsPerBlock * gathered * sizeof(Complex) + PaddedTransform::bytes(longer));
}

/// Two real rows that were transformed as one complex row, z = a + i b:
/// A[k] = (Z[k] + conj Z[-k]) / 2, B[k] = (Z[k] - conj Z[-k]) / 2i, here both times 2.
class RowPair {
 public:
  RowPair(const PaddedTransform::Frequencies& z, int part_length) : z_(z), last_(part_length - 1) {}

  /// The columns of one block.
  void write(int block, float* a, float* b) const {
    constexpr int kParts = PaddedTransform::kParts, kQuarters = kColumnsPerBlock / kParts;
    for (int i = 0; i < kQuarters; ++i, a += 2 * kParts, b += 2 * kParts) {
      const int q = block * kQuarters + i, mirrored = last_ - q;
      // -k = 4 (length / 4 - q) for a remainder of 0, else 4 (length / 4 - 1 - q) + 4 - r.
      split(z_[0] + q, z_[0] + (q == 0 ? 0 : mirrored + 1), a, b);
      split(z_[1] + q, z_[3] + mirrored, a + 2, b + 2);
      split(z_[2] + q, z_[2] + mirrored, a + 4, b + 4);
      split(z_[3] + q, z_[1] + mirrored, a + 6, b + 6);
    }
  }

 private:
  static void split(const Complex* plus, const Complex* minus, float* a, float* b) {
    const float plus_re = plus->real(), plus_im = plus->imag();
    const float minus_re = minus->real(), minus_im = minus->imag();
    a[0] = plus_re + minus_re;
    a[1] = plus_im - minus_im;
    b[0] = plus_im + minus_im;
    b[1] = minus_re - plus_re;
  }

  PaddedTransform::Frequencies z_;
  int last_;
};

/// The first pass: transforms of the open rows, in blocks of columns kx. Scaled so that the squares
/// of the full transform are the intensity in mm^2.
class RowPass {
 public:
  RowPass(const Aperture& aperture, double energy_area_mm2, const OpenPart& part,
          const Layout& layout, float* blocks)
      : aperture_(aperture),
        part_(part),
        layout_(layout),
        blocks_(blocks),
        transform_(part.width, layout.x.length),
        scale_(static_cast<float>(0.5 * aperture.pixel_mm() * aperture.pixel_mm() /
                                  std::sqrt(energy_area_mm2))) {}

  void run(int threads, const ProgressCallback& progress) {
    const auto rows = [this](int task) {
      const auto workspace = pool_.take();
      const int end = std::min(part_.height, (task + 1) * kRowsPerTask);
      for (int y = task * kRowsPerTask; y < end; y += 2) transform_pair(y, *workspace);
    };
    parallel_for((part_.height + kRowsPerTask - 1) / kRowsPerTask, threads, rows, progress);
  }

 private:
  bool has(int y) const { return y < part_.height; }
  std::span<const float> row(int y) const {
    return aperture_.transmittance.row(part_.y0 + y).subspan(part_.x0, part_.width);
  }

  void transform_pair(int y, Workspace& workspace) {
    const auto samples = workspace.samples.values(transform_.input_count());
    const auto a = row(y), b = row(has(y + 1) ? y + 1 : y);
    const float scale_b = has(y + 1) ? scale_ : 0;
    for (std::size_t x = 0; x < a.size(); ++x) samples[x] = {scale_ * a[x], scale_b * b[x]};
    std::fill(samples.begin() + part_.width, samples.end(), Complex());
    const auto z = transform_.execute(samples, workspace.transform);
    const RowPair pair(z, PaddedTransform::part_length(layout_.x.length));
    std::array<float, kFloatsPerBlockRow> nothing;
    for (int block = 0; block < layout_.blocks; ++block) {
      float* const target = blocks_ + block * layout_.block_floats + y * kFloatsPerBlockRow;
      pair.write(block, target, has(y + 1) ? target + kFloatsPerBlockRow : nothing.data());
    }
  }

  const Aperture& aperture_;
  const OpenPart& part_;
  const Layout& layout_;
  float* blocks_;
  PaddedTransform transform_;
  float scale_;
  WorkspacePool<Workspace> pool_;
};

float norm(const Complex& z) { return z.real() * z.real() + z.imag() * z.imag(); }

/// |X[k]|^2 for k from `first` on.
void write_norms(const PaddedTransform::Frequencies& x, int first, std::span<float> result) {
  constexpr int kParts = PaddedTransform::kParts;
  std::size_t i = 0;
  const auto next = [&] {
    const int k = first + static_cast<int>(i);
    result[i++] = norm(x[k % kParts][k / kParts]);
  };
  while (i < result.size() && (first + i) % kParts != 0) next();
  const std::size_t quarter = (first + i) / kParts;
  const std::size_t whole = (result.size() - i) / kParts;
  const Complex *x0 = x[0] + quarter, *x1 = x[1] + quarter, *x2 = x[2] + quarter,
                *x3 = x[3] + quarter;
  float* __restrict target = result.data() + i;
  for (std::size_t q = 0; q < whole; ++q) {
    target[kParts * q] = norm(x0[q]);
    target[kParts * q + 1] = norm(x1[q]);
    target[kParts * q + 2] = norm(x2[q]);
    target[kParts * q + 3] = norm(x3[q]);
  }
  i += kParts * whole;
  while (i < result.size()) next();
}

/// The second pass: transforms of the columns; |T|^2 into row kx of the field, for kx >= 0.
class ColumnPass {
 public:
  ColumnPass(const Layout& layout, const float* blocks, FarField& field)
      : layout_(layout),
        blocks_(blocks),
        field_(field),
        transform_(layout.open_height, layout.y.length) {
    if (layout.copy_floats() > 0) copies_.emplace(static_cast<std::size_t>(layout.copy_floats()));
  }

  void run(int threads, const ProgressCallback& progress) {
    for (const Wave& wave : layout_.waves) {
      const auto share = [this](int block) { return static_cast<double>(block) / layout_.blocks; };
      const auto part = progress_part(progress, share(wave.begin), share(wave.end));
      const int count = wave.end - wave.begin;
      if (wave.copied) parallel_for(count, threads, [&](int i) { copy(wave.begin + i, i); });
      const auto one = [&](int i) {
        transform_block(wave.begin + i, wave.copied ? copy_of(i) : block(wave.begin + i));
      };
      parallel_for(count, threads, one, part);
    }
  }

 private:
  const float* block(int index) const { return blocks_ + index * layout_.block_floats; }
  float* copy_of(int i) { return copies_->values().data() + i * layout_.block_floats; }
  void copy(int index, int i) { std::copy_n(block(index), layout_.block_floats, copy_of(i)); }

  void transform_block(int index, const float* source) {
    const auto workspace = pool_.take();
    const auto length = static_cast<std::size_t>(transform_.input_count());
    const std::size_t stride = length + kColumnsPerBlock;  // Not all in one place of the cache.
    const auto columns = workspace->samples.values(kColumnsPerBlock * stride);
    const auto rows = static_cast<std::size_t>(layout_.open_height);
    for (std::size_t y = 0; y < rows; ++y, source += kFloatsPerBlockRow)
      for (std::size_t c = 0; c < kColumnsPerBlock; ++c)
        columns[c * stride + y] = {source[2 * c], source[2 * c + 1]};
    const int kx0 = index * kColumnsPerBlock;
    for (int c = 0; c < std::min(kColumnsPerBlock, layout_.count - kx0); ++c) {
      const auto column = columns.subspan(c * stride, length);
      std::fill(column.begin() + layout_.open_height, column.end(), Complex());
      write_row(kx0 + c, transform_.execute(column, workspace->transform));
    }
  }

  /// The frequencies repeat at the transform's length.
  void write_row(int kx, const PaddedTransform::Frequencies& frequencies) {
    auto rest = field_.intensity_mm2.row(kx - field_.first_kx);
    const int length = layout_.y.length;
    int k = field_.first_ky % length;
    if (k < 0) k += length;
    for (; !rest.empty(); k = 0) {
      const auto run = std::min(rest.size(), static_cast<std::size_t>(length - k));
      write_norms(frequencies, k, rest.first(run));
      rest = rest.subspan(run);
    }
  }

  const Layout& layout_;
  const float* blocks_;
  FarField& field_;
  PaddedTransform transform_;
  std::optional<AlignedBuffer<float>> copies_;
  WorkspacePool<Workspace> pool_;
};

/// Fills row kx, which was not transformed: frequencies repeat at the transform's length, and
/// I(-f) = I(f). The row of -ky is the row of ky backwards, since ky runs from -last to last.
void fill_row_by_symmetry(FarField& field, int kx, const Axis& axis) {
  int source_kx = kx % axis.length;
  if (source_kx > axis.length / 2) source_kx -= axis.length;
  if (source_kx < -(axis.length / 2)) source_kx += axis.length;
  const auto source = field.intensity_mm2.row(std::abs(source_kx) - field.first_kx);
  const auto target = field.intensity_mm2.row(kx - field.first_kx);
  if (source_kx < 0)
    std::reverse_copy(source.begin(), source.end(), target.begin());
  else
    std::copy(source.begin(), source.end(), target.begin());
}

/// Both passes: the rows kx >= 0 that follow from no others.
void transform(const Aperture& aperture, const OpenPart& part, const Layout& layout,
               const FarFieldRequest& request, FarField& field) {
  std::optional<AlignedBuffer<float>> own;
  if (!layout.shared) own.emplace(static_cast<std::size_t>(layout.blocks_floats()));
  float* const memory = own ? own->values().data() : field.intensity_mm2.values().data();
  float* const blocks = memory + layout.blocks_start();
  RowPass(aperture, field.energy_area_mm2, part, layout, blocks)
      .run(request.threads, progress_part(request.progress, 0, 0.3));
  ColumnPass(layout, blocks, field).run(request.threads, progress_part(request.progress, 0.3, 1));
}

}  // namespace

FarField far_field(const Aperture& aperture, const FarFieldRequest& request) {
  require_valid(aperture);
  const OpenPart part = open_part(aperture);
  const double pixel_mm = aperture.pixel_mm();
  const Layout layout(part.width, part.height, pixel_mm, request);

  FarField field;
  field.first_kx = -layout.overlap;
  field.first_ky = -layout.y.last_k;
  field.bin_x_per_mm = layout.x.bin_per_mm;
  field.bin_y_per_mm = layout.y.bin_per_mm;
  field.extent_x_mm = part.width * pixel_mm;
  field.extent_y_mm = part.height * pixel_mm;
  field.aperture_pixel_mm = pixel_mm;
  field.aperture_width_mm = aperture.width_mm;
  field.energy_area_mm2 = energy_area_mm2(aperture);
  field.intensity_mm2 =
      Image<float>::uninitialized(static_cast<int>(layout.width), static_cast<int>(layout.height));

  transform(aperture, part, layout, request, field);
  for (int kx = field.first_kx; kx < 0; ++kx) fill_row_by_symmetry(field, kx, layout.x);
  for (int kx = layout.count; kx <= layout.x.last_k; ++kx)
    fill_row_by_symmetry(field, kx, layout.x);
  return field;
}

std::uint64_t far_field_bytes(int width, int height, double pixel_mm,
                              const FarFieldRequest& request) {
  const Layout layout(width, height, pixel_mm, request);
  const std::int64_t floats =
      layout.floats() + (layout.shared ? layout.copy_floats() : layout.blocks_floats());
  return static_cast<std::uint64_t>(floats) * sizeof(float) +
         workspace_bytes(layout, request.threads);
}

std::array<int, 2> far_field_transform_lengths(int width, int height, double pixel_mm,
                                               const FarFieldRequest& request) {
  const Layout layout(width, height, pixel_mm, request);
  return {PaddedTransform::part_length(layout.x.length),
          PaddedTransform::part_length(layout.y.length)};
}

}  // namespace glare
