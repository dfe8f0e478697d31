#include "glare/diffraction/far_field.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>

#include "glare/aperture/open_part.h"
#include "glare/base/parallel.h"
#include "glare/diffraction/fourier_transform.h"

namespace glare {

namespace {

using ComplexImage = Image<std::complex<float>>;

constexpr int kColumnsPerTask = 8;
constexpr int kRowsPerTask = 16;

/// Sizes along one axis: transform length, and the samples held.
struct Axis {
  int length = 0;         ///< Of the zero-padded transform.
  double bin_per_mm = 0;  ///< Distance between its frequencies.
  int last_k = 0;         ///< The largest frequency index held.

  Axis(int open_samples, double pixel_mm, double max_frequency_per_mm, double padding) {
    constexpr int kShortest = 64;
    length = fast_transform_length(
        std::max(kShortest, static_cast<int>(std::ceil(padding * open_samples))));
    bin_per_mm = 1 / (length * pixel_mm);
    last_k = static_cast<int>(std::ceil(max_frequency_per_mm / bin_per_mm)) + kFarFieldMargin;
  }
};

/// Transforms of the open rows, zero-padded to the axis' length: for each row the frequencies
/// 0 to `count` - 1. Scaled so that the squares of the full transform are the intensity in mm^2.
ComplexImage transformed_rows(const Aperture& aperture, const OpenPart& part, const Axis& axis,
                              int count, int threads, const ProgressCallback& progress) {
  const FourierTransform transform(FourierTransform::Kind::real_to_complex, axis.length);
  const auto scale = static_cast<float>(aperture.pixel_mm() * aperture.pixel_mm() /
                                        std::sqrt(energy_area_mm2(aperture)));
  ComplexImage rows(count, part.height);
  const auto transform_rows = [&](int task) {
    TransformBuffer<float> samples(static_cast<std::size_t>(axis.length));
    TransformBuffer<std::complex<float>> frequencies(static_cast<std::size_t>(axis.length / 2 + 1));
    const int end = std::min(part.height, (task + 1) * kRowsPerTask);
    for (int y = task * kRowsPerTask; y < end; ++y) {
      const auto row = aperture.transmittance.row(part.y0 + y).subspan(part.x0, part.width);
      const auto rest = std::transform(row.begin(), row.end(), samples.values().begin(),
                                       [scale](float t) { return t * scale; });
      std::fill(rest, samples.values().end(), 0.0f);
      transform.execute(samples, frequencies);
      std::copy_n(frequencies.values().begin(), count, rows.row(y).begin());
    }
  };
  parallel_for((part.height + kRowsPerTask - 1) / kRowsPerTask, threads, transform_rows, progress);
  return rows;
}

/// Transforms the columns in place of `rows` and writes |T|^2: row kx of `field` for kx >= 0.
void transform_columns(const ComplexImage& rows, const Axis& axis, FarField& field, int threads,
                       const ProgressCallback& progress) {
  const FourierTransform transform(FourierTransform::Kind::complex_to_complex, axis.length);
  const int tasks = (rows.width() + kColumnsPerTask - 1) / kColumnsPerTask;
  const auto one_task = [&](int task) {
    const int kx0 = task * kColumnsPerTask;
    const int columns = std::min(kColumnsPerTask, rows.width() - kx0);
    Image<std::complex<float>> gathered(rows.height(), columns);
    for (int y = 0; y < rows.height(); ++y)
      for (int c = 0; c < columns; ++c) gathered(y, c) = rows(kx0 + c, y);
    TransformBuffer<std::complex<float>> column(static_cast<std::size_t>(axis.length));
    for (int c = 0; c < columns; ++c) {
      const auto values = column.values();
      const auto filled = gathered.row(c);
      std::fill(std::copy(filled.begin(), filled.end(), values.begin()), values.end(), 0.0f);
      transform.execute(column);
      const auto intensity = field.intensity_mm2.row(kx0 + c - field.first_kx);
      int k = field.first_ky % axis.length;
      if (k < 0) k += axis.length;
      for (float& i : intensity) {
        i = std::norm(values[k]);
        if (++k == axis.length) k = 0;
      }
    }
  };
  parallel_for(tasks, threads, one_task, progress);
}

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

/// The frequencies kx >= 0 that are transformed; the rest follow by symmetry.
int transformed_count(const Axis& axis) { return std::min(axis.last_k, axis.length / 2) + 1; }

/// Rows held on the other side of the axis; they repeat rows that are held anyway.
int overlap_count(const FarFieldRequest& request, const Axis& axis) {
  const double samples = request.overlap_frequency_x_per_mm / axis.bin_per_mm;
  return std::min(axis.last_k, static_cast<int>(std::ceil(samples)) + kFarFieldMargin);
}

}  // namespace

FarField far_field(const Aperture& aperture, const FarFieldRequest& request) {
  require_valid(aperture);
  const OpenPart part = open_part(aperture);
  const double pixel_mm = aperture.pixel_mm();
  const Axis axis_x(part.width, pixel_mm, request.max_frequency_x_per_mm, request.padding);
  const Axis axis_y(part.height, pixel_mm, request.max_frequency_y_per_mm, request.padding);

  FarField field;
  field.first_kx = -overlap_count(request, axis_x);
  field.first_ky = -axis_y.last_k;
  field.bin_x_per_mm = axis_x.bin_per_mm;
  field.bin_y_per_mm = axis_y.bin_per_mm;
  field.extent_x_mm = part.width * pixel_mm;
  field.extent_y_mm = part.height * pixel_mm;
  field.aperture_pixel_mm = pixel_mm;
  field.aperture_width_mm = aperture.width_mm;
  field.energy_area_mm2 = energy_area_mm2(aperture);
  field.intensity_mm2 = Image<float>(2 * axis_y.last_k + 1, axis_x.last_k - field.first_kx + 1);

  const int count = transformed_count(axis_x);
  const ComplexImage rows = transformed_rows(aperture, part, axis_x, count, request.threads,
                                             progress_part(request.progress, 0, 0.4));
  transform_columns(rows, axis_y, field, request.threads, progress_part(request.progress, 0.4, 1));
  for (int kx = field.first_kx; kx < 0; ++kx) fill_row_by_symmetry(field, kx, axis_x);
  for (int kx = count; kx <= axis_x.last_k; ++kx) fill_row_by_symmetry(field, kx, axis_x);
  return field;
}

std::uint64_t far_field_bytes(int width, int height, double pixel_mm,
                              const FarFieldRequest& request) {
  const Axis axis_x(width, pixel_mm, request.max_frequency_x_per_mm, request.padding);
  const Axis axis_y(height, pixel_mm, request.max_frequency_y_per_mm, request.padding);
  const auto count = static_cast<std::uint64_t>(transformed_count(axis_x));
  const auto intensity =
      static_cast<std::uint64_t>(2 * axis_y.last_k + 1) *
      static_cast<std::uint64_t>(axis_x.last_k + overlap_count(request, axis_x) + 1);
  return count * static_cast<std::uint64_t>(height) * sizeof(std::complex<float>) +
         intensity * sizeof(float);
}

}  // namespace glare
