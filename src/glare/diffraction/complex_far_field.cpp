#include "glare/diffraction/complex_far_field.h"

#include <algorithm>
#include <cmath>

#include "glare/base/parallel.h"
#include "glare/diffraction/padded_transform.h"

namespace glare {

namespace {

using Complex = std::complex<float>;

constexpr int kRowsPerTask = 16;
/// Between the two passes the columns lie in blocks, row by row: a row of a block is a cache line.
constexpr int kColumnsPerBlock = 8;

/// Sizes along one axis: transform length, and the samples held.
struct Axis {
  int length;
  double bin_per_mm;
  int last_k;

  Axis(int samples, double pixel_mm, double max_frequency_per_mm, double padding) {
    constexpr int kShortest = 64;
    const int least = std::max(kShortest, static_cast<int>(std::ceil(padding * samples)));
    length = 2 * fast_transform_length((least + 1) / 2);
    bin_per_mm = 1 / (length * pixel_mm);
    last_k = static_cast<int>(std::ceil(max_frequency_per_mm / bin_per_mm)) + kFarFieldMargin;
  }
  /// The frequencies repeat at the transform's length.
  int wrapped(int k) const { return (k % length + length) % length; }
};

struct Layout {
  Axis x, y;
  int overlap;  ///< Rows kx < 0 of a half plane.
  int columns;  ///< kx from -last to last, between the passes.
  int blocks;

  Layout(int width, int height, double pixel_mm, const FarFieldRequest& request)
      : x(width, pixel_mm, request.max_frequency_x_per_mm, request.padding),
        y(height, pixel_mm, request.max_frequency_y_per_mm, request.padding),
        overlap(std::min(x.last_k, static_cast<int>(std::ceil(request.overlap_frequency_x_per_mm /
                                                              x.bin_per_mm)) +
                                       kFarFieldMargin)),
        columns(2 * x.last_k + 1),
        blocks((columns + kColumnsPerBlock - 1) / kColumnsPerBlock) {}
};

struct Workspace {
  GrowingBuffer<Complex> plus, minus;
  PaddedTransform::Workspace plus_transform, minus_transform;
};

/// The two passes; between them the transformed rows.
class Transform {
 public:
  Transform(const ComplexOpenPart& part, const Layout& layout)
      : part_(part),
        layout_(layout),
        block_values_(static_cast<std::size_t>(kColumnsPerBlock) *
                      static_cast<std::size_t>(part.height)),
        between_(block_values_ * static_cast<std::size_t>(layout.blocks)),
        scale_(
            static_cast<float>(part.pixel_mm * part.pixel_mm / std::sqrt(part.energy_area_mm2))) {}

  void rows(int threads, const ProgressCallback& progress) {
    const PaddedTransform transform(part_.width, layout_.x.length);
    WorkspacePool<Workspace> pool;
    const auto task = [&](int i) {
      const auto work = pool.take();
      const int end = std::min(part_.height, (i + 1) * kRowsPerTask);
      for (int y = i * kRowsPerTask; y < end; ++y) one_row(y, transform, *work);
    };
    parallel_for((part_.height + kRowsPerTask - 1) / kRowsPerTask, threads, task, progress);
  }

  /// Row kx >= 0 of both parts, from the columns kx and -kx.
  void columns(FarFieldParts& result, int threads, const ProgressCallback& progress) {
    const PaddedTransform transform(part_.height, layout_.y.length);
    WorkspacePool<Workspace> pool;
    const auto task = [&](int kx) {
      const auto work = pool.take();
      const auto plus = column(kx, transform, work->plus, work->plus_transform);
      const auto minus = column(-kx, transform, work->minus, work->minus_transform);
      const auto even = result.even.intensity_mm2.row(kx + layout_.overlap);
      const auto odd = result.odd.intensity_mm2.row(kx + layout_.overlap);
      for (std::size_t i = 0; i < even.size(); ++i) {
        const int ky = static_cast<int>(i) - layout_.y.last_k;
        const float here = intensity(plus, ky), opposite = intensity(minus, -ky);
        even[i] = 0.5f * (here + opposite);
        odd[i] = 0.5f * (here - opposite);
      }
    };
    parallel_for(layout_.x.last_k + 1, threads, task, progress);
  }

 private:
  Complex& between(int column, int y) {
    const auto block = static_cast<std::size_t>(column / kColumnsPerBlock);
    return between_
        .values()[block * block_values_ + static_cast<std::size_t>(y) * kColumnsPerBlock +
                  static_cast<std::size_t>(column % kColumnsPerBlock)];
  }

  void one_row(int y, const PaddedTransform& transform, Workspace& work) {
    const auto samples = work.plus.values(static_cast<std::size_t>(transform.input_count()));
    const auto open = samples.first(static_cast<std::size_t>(part_.width));
    part_.row(y, open);
    for (Complex& value : open) value *= scale_;
    std::fill(samples.begin() + part_.width, samples.end(), Complex());
    const auto z = transform.execute(samples, work.plus_transform);
    for (int column = 0; column < layout_.columns; ++column) {
      const int k = layout_.x.wrapped(column - layout_.x.last_k);
      between(column, y) = z[static_cast<std::size_t>(k % 4)][k / 4];
    }
  }

  PaddedTransform::Frequencies column(int kx, const PaddedTransform& transform,
                                      GrowingBuffer<Complex>& buffer,
                                      PaddedTransform::Workspace& work) {
    const auto samples = buffer.values(static_cast<std::size_t>(transform.input_count()));
    for (int y = 0; y < part_.height; ++y)
      samples[static_cast<std::size_t>(y)] = between(kx + layout_.x.last_k, y);
    std::fill(samples.begin() + part_.height, samples.end(), Complex());
    return transform.execute(samples, work);
  }

  float intensity(const PaddedTransform::Frequencies& frequencies, int ky) const {
    const int k = layout_.y.wrapped(ky);
    return std::norm(frequencies[static_cast<std::size_t>(k % 4)][k / 4]);
  }

  const ComplexOpenPart& part_;
  const Layout& layout_;
  std::size_t block_values_;
  AlignedBuffer<Complex> between_;
  float scale_;
};

FarField empty_field(const ComplexOpenPart& part, const Layout& layout) {
  FarField field;
  field.first_kx = -layout.overlap;
  field.first_ky = -layout.y.last_k;
  field.bin_x_per_mm = layout.x.bin_per_mm;
  field.bin_y_per_mm = layout.y.bin_per_mm;
  field.extent_x_mm = part.width * part.pixel_mm;
  field.extent_y_mm = part.height * part.pixel_mm;
  field.aperture_pixel_mm = part.pixel_mm;
  field.energy_area_mm2 = part.energy_area_mm2;
  field.intensity_mm2 =
      Image<float>::uninitialized(2 * layout.y.last_k + 1, layout.overlap + layout.x.last_k + 1);
  return field;
}

/// The rows kx < 0 that are held: those of -kx backwards, of the odd part with the other sign.
void fill_overlap(FarField& field) {
  for (int kx = field.first_kx; kx < 0; ++kx) {
    const auto source = field.intensity_mm2.row(-kx - field.first_kx);
    const auto target = field.intensity_mm2.row(kx - field.first_kx);
    std::reverse_copy(source.begin(), source.end(), target.begin());
    if (field.odd)
      for (float& value : target) value = -value;
  }
}

}  // namespace

FarFieldParts complex_far_field(const ComplexOpenPart& part, const FarFieldRequest& request) {
  const Layout layout(part.width, part.height, part.pixel_mm, request);
  FarFieldParts result{empty_field(part, layout), empty_field(part, layout)};
  result.odd.odd = true;
  Transform transform(part, layout);
  transform.rows(request.threads, progress_part(request.progress, 0, 0.4));
  transform.columns(result, request.threads, progress_part(request.progress, 0.4, 1));
  fill_overlap(result.even);
  fill_overlap(result.odd);
  return result;
}

std::uint64_t complex_far_field_bytes(int width, int height, double pixel_mm,
                                      const FarFieldRequest& request) {
  const Layout layout(width, height, pixel_mm, request);
  const auto size = [](int a, int b) {
    return static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b);
  };
  const int longer = std::max(layout.x.length, layout.y.length);
  return 2 * size(2 * layout.y.last_k + 1, layout.overlap + layout.x.last_k + 1) * sizeof(float) +
         size(layout.blocks * kColumnsPerBlock, height) * sizeof(Complex) +
         2 * static_cast<std::uint64_t>(threads_used(request.threads)) *
             (PaddedTransform::bytes(longer) + size(longer, 1) * sizeof(Complex));
}

}  // namespace glare
