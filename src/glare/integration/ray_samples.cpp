#include "glare/integration/ray_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "glare/integration/point_interpolation.h"
#include "glare/integration/sampling_density.h"

namespace glare {

namespace {

/// Samples on either side of a place that interpolation along the minor coordinate takes in, at
/// most.
constexpr int kMargin = InterpolationTable<12>::kTaps / 2;

/// Across rows of the far field.
const PointInterpolation& major_interpolation(bool fine) {
  static const PointInterpolation interpolation(WindowedSinc{8, 6.5});
  static const PointInterpolation fine_interpolation(WindowedSinc{12, 8.5});
  return fine ? fine_interpolation : interpolation;
}

/// Interpolates along the minor coordinate, with more taps where the pattern is steep or its
/// samples are few.
void interpolate_minor(bool fine, const float* row, const EvenPlaces& places, float* result) {
  static const InterpolationTable<8> table(6.5);
  static const InterpolationTable<12> fine_table(8.5);
  if (fine)
    interpolate(row, places, fine_table, result);
  else
    interpolate(row, places, table, result);
}

}  // namespace

DecimationFilter::DecimationFilter(int decimation) : weights_{1} {
  constexpr int kReach = 4;
  constexpr WindowedSinc kKernel{2 * kReach, 5};
  constexpr double kCutoff = 1;
  if (decimation == 1) return;
  weights_.clear();
  double sum = 0;
  for (int s = -kReach * decimation; s <= kReach * decimation; ++s) {
    weights_.push_back(windowed_sinc(kKernel, static_cast<double>(s) / decimation, kCutoff));
    sum += weights_.back();
  }
  for (double& weight : weights_) weight /= sum;
}

double DecimationFilter::response(double cycles) const {
  // cos(s x) by the recurrence of Chebyshev's polynomials.
  const double cosine = std::cos(2 * std::numbers::pi * cycles);
  double sum = weight(0), before = 1, here = cosine;
  for (int s = 1; s <= reach(); ++s) {
    sum += 2 * weight(s) * here;
    const double next = 2 * cosine * here - before;
    before = here;
    here = next;
  }
  return sum;
}

RaySamples::RaySamples(const FarField& field, const RayBand& band, const LogRows& rows)
    : field_(field), band_(band), rows_(rows) {
  const bool x_major = band.sector == Sector::x_major;
  major_bin_per_mm_ = x_major ? field.bin_x_per_mm : field.bin_y_per_mm;
  minor_samples_ =
      band.ray_step * major_bin_per_mm_ / (x_major ? field.bin_y_per_mm : field.bin_x_per_mm);
  last_major_ = x_major ? field.first_kx + field.intensity_mm2.height() - 1
                        : field.first_ky + field.intensity_mm2.width() - 1;
  fine_ = band.near_axis || !is_densely_sampled(field);
  log_scale_ = rows.first_log_per_mm + 0.5 * rows.count * rows.step();
  set_weights();
}

void RaySamples::set_weights() {
  const DecimationFilter filter(rows_.decimation);
  const PointInterpolation& interpolation = major_interpolation(fine_);
  const int half = interpolation.taps() / 2;
  const int reach = filter.reach();
  const auto place_of = [&](double log) { return std::exp(log) / major_bin_per_mm_; };
  std::vector<double> weights;
  for (int m = 0; m < rows_.count; ++m) {
    const double middle = rows_.first_log_per_mm + m * rows_.step();
    const int first = static_cast<int>(place_of(middle - reach * rows_.fine_step)) - half + 1;
    const int last = static_cast<int>(place_of(middle + reach * rows_.fine_step)) + half;
    weights.assign(static_cast<std::size_t>(last - first + 1), 0.0);
    for (int s = -reach; s <= reach; ++s) {
      const double log = middle + s * rows_.fine_step;
      const double place = place_of(log), whole = std::floor(place);
      const double scale = filter.weight(s) * std::exp(kWhitening * (log - log_scale_));
      const auto taps = interpolation.weights_at(place - whole);
      double* const target = weights.data() + (static_cast<int>(whole) - half + 1 - first);
      for (int j = 0; j < 2 * half; ++j) target[j] += scale * taps[j];
    }
    // What would lie beyond the samples that are held counts for the last of them.
    WeightedRows row;
    row.first = std::clamp(first, 0, last_major_);
    const int held = std::clamp(last, 0, last_major_) - row.first + 1;
    row.place = std::clamp<double>(place_of(middle), row.first, row.first + held - 1);
    row.weights.assign(static_cast<std::size_t>(held), 0.0f);
    for (int k = first; k <= last; ++k)
      row.weights[static_cast<std::size_t>(std::clamp(k, 0, last_major_) - row.first)] +=
          static_cast<float>(weights[static_cast<std::size_t>(k - first)]);
    weighted_.push_back(std::move(row));
  }
}

void RaySamples::sample(int first_ray, Workspace& work, float* result) const {
  const int count = std::min(kRaysPerTile, band_.rays_each_side + 1 - first_ray);
  if (rows_.decimation == 1)
    sample_by_row(first_ray, count, work, result);
  else
    sample_averaged(first_ray, count, work, result);
}

/// Each row is interpolated where it lies and then, along it, where the rays cross it.
void RaySamples::sample_by_row(int first_ray, int count, Workspace& work, float* result) const {
  constexpr int kChunk = 32;
  std::size_t m = 0;
  while (m < weighted_.size()) {
    const int row0 = weighted_[m].first;
    std::size_t end = m;
    int row1 = row0;
    for (; end < weighted_.size() && weighted_[end].first < row0 + kChunk; ++end)
      row1 = std::max(row1, weighted_[end].first + static_cast<int>(weighted_[end].weights.size()));
    const Window rows = window(first_ray, count, row0, row1, work);
    for (; m < end; ++m) {
      const WeightedRows& row = weighted_[m];
      const double step = minor_samples_ * row.place, first = first_ray * step;
      const int begin = static_cast<int>(std::floor(first)) - kMargin + 1;
      const int span =
          static_cast<int>(std::floor(first + (count - 1) * step)) + kMargin + 1 - begin;
      work.line.resize(static_cast<std::size_t>(span));
      sum_weighted_rows(
          row.weights, rows.rows + static_cast<std::size_t>(row.first - row0) * rows.stride + begin,
          rows.stride, span, work.line.data());
      float* const target = result + m * kRaysPerTile;
      interpolate_minor(fine_, work.line.data(), {first - begin, step, count}, target);
      std::fill(target + count, target + kRaysPerTile, 0.0f);
    }
  }
}

/// The far field's own rows are interpolated where the rays cross them, and then averaged along the
/// rays: interpolation across rows errs in detail that is averaged away.
void RaySamples::sample_averaged(int first_ray, int count, Workspace& work, float* result) const {
  constexpr int kChunk = 64;
  const int row0 = weighted_.front().first;
  const int row1 = weighted_.back().first + static_cast<int>(weighted_.back().weights.size());
  work.sampled.resize(static_cast<std::size_t>(row1 - row0) * kRaysPerTile);
  for (int chunk = row0; chunk < row1; chunk += kChunk) {
    const int end = std::min(chunk + kChunk, row1);
    const Window rows = window(first_ray, count, chunk, end, work);
    for (int k = chunk; k < end; ++k) {
      const double step = minor_samples_ * k;
      float* const target = work.sampled.data() + static_cast<std::size_t>(k - row0) * kRaysPerTile;
      interpolate_minor(fine_, rows.rows + static_cast<std::size_t>(k - chunk) * rows.stride,
                        {first_ray * step, step, count}, target);
      std::fill(target + count, target + kRaysPerTile, 0.0f);
    }
  }
  for (std::size_t m = 0; m < weighted_.size(); ++m)
    sum_weighted_rows(
        weighted_[m].weights,
        work.sampled.data() + static_cast<std::size_t>(weighted_[m].first - row0) * kRaysPerTile,
        kRaysPerTile, kRaysPerTile, result + m * kRaysPerTile);
}

/// The rows row0 to row1 - 1 where the rays cross them, and a little to either side. The far field
/// is held by rows of kx, so those of ky are transposed; and only kx >= 0: I(-f) = I(f).
RaySamples::Window RaySamples::window(int first_ray, int count, int row0, int row1,
                                      Workspace& work) const {
  const double lowest = first_ray * minor_samples_;
  const double highest = (first_ray + count - 1) * minor_samples_;
  const int begin = static_cast<int>(std::floor(std::min(lowest * row0, lowest * row1))) - kMargin;
  const int end =
      static_cast<int>(std::floor(std::max(highest * row0, highest * row1))) + kMargin + 2;
  const Image<float>& intensity = field_.intensity_mm2;
  if (band_.sector == Sector::x_major && begin >= field_.first_ky &&
      end <= field_.first_ky + intensity.width())
    return {intensity.row(row0 - field_.first_kx).data() - field_.first_ky,
            static_cast<std::size_t>(intensity.width())};

  const auto span = static_cast<std::size_t>(end - begin);
  work.transposed.resize(span * static_cast<std::size_t>(row1 - row0));
  if (band_.sector == Sector::x_major)
    copy_rows(begin, end, row0, row1, work.transposed.data());
  else
    transpose_rows(begin, end, row0, row1, work.transposed.data());
  return {work.transposed.data() - begin, span};
}

/// Where the outermost rays leave the field, which no pixel needs, its last samples are repeated.
void RaySamples::copy_rows(int begin, int end, int row0, int row1, float* target) const {
  const Image<float>& intensity = field_.intensity_mm2;
  for (int kx = row0; kx < row1; ++kx) {
    const auto row = intensity.row(kx - field_.first_kx);
    for (int ky = begin; ky < end; ++ky)
      *target++ =
          row[static_cast<std::size_t>(std::clamp(ky - field_.first_ky, 0, intensity.width() - 1))];
  }
}

void RaySamples::transpose_rows(int begin, int end, int row0, int row1, float* target) const {
  const Image<float>& intensity = field_.intensity_mm2;
  const int last_kx = field_.first_kx + intensity.height() - 1;
  const auto span = static_cast<std::size_t>(end - begin);
  const auto stride = static_cast<std::ptrdiff_t>(intensity.width());
  const auto source = [&](int kx, int ky) {
    return intensity.row(kx - field_.first_kx).data() + (ky - field_.first_ky);
  };
  // Beyond the samples on the other side of the axis; kx < 0; kx >= 0; beyond the samples here.
  const int first = std::clamp(-last_kx, begin, end), last = std::clamp(last_kx + 1, first, end);
  const int middle = std::clamp(0, first, last);
  if (first < middle)
    transpose(source(-first, -row0), -stride, -1, middle - first, row1 - row0,
              target + (first - begin), span);
  const float sign = field_.odd ? -1.0f : 1.0f;
  if (field_.odd)
    for (int ky = row0; ky < row1; ++ky)
      for (int kx = first; kx < middle; ++kx)
        target[(ky - row0) * (end - begin) + kx - begin] *= -1;
  if (middle < last)
    transpose(source(middle, row0), stride, 1, last - middle, row1 - row0,
              target + (middle - begin), span);
  for (int ky = row0; ky < row1; ++ky, target += span) {
    std::fill(target, target + (first - begin), sign * *source(last_kx, -ky));
    std::fill(target + (last - begin), target + span, *source(last_kx, ky));
  }
}

}  // namespace glare
