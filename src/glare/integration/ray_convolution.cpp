#include "glare/integration/ray_convolution.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace glare {

namespace {

/// Rows at either end over which a decimated kernel rings.
constexpr int kRingingRows = 6;

constexpr int kSignals = BlockTransform::kSignals;  ///< Two rays make a complex signal.

}  // namespace

RayXyz RayConvolution::layout(const RayBand& band) {
  RayXyz rays;
  rays.log_step = band.fine_step * band.decimation;
  rays.first_log_rad = std::log(band.first_rad) - kMarginRows * rays.log_step;
  rays.rows =
      static_cast<int>(std::ceil(std::log(band.last_rad / band.first_rad) / rays.log_step)) +
      2 * kMarginRows + 1;
  rays.ray_step = band.ray_step;
  rays.first_ray = -band.rays_each_side;
  rays.blocks = (2 * band.rays_each_side + kRaysPerBlock) / kRaysPerBlock;
  return rays;
}

std::size_t RayConvolution::value_count(const RayBand& band) {
  const RayXyz rays = layout(band);
  return 3 * static_cast<std::size_t>(rays.blocks) * rays.block_size();
}

RayConvolution::RayConvolution(const FarField& field, const RayBand& band, const LogSpectrum& light,
                               std::span<float> memory)
    : result_(layout(band)) {
  assert(memory.size() == value_count(band) && light.log_step == band.fine_step);
  result_.values = memory;
  const int decimation = band.decimation;
  const double step = result_.log_step;
  const int guard = decimation == 1 ? 0 : kRingingRows;
  const int taps = (static_cast<int>(light.weights.size()) + decimation - 1) / decimation;
  sampled_rows_ = result_.rows + taps + 2 * guard;
  transform_ = std::make_unique<BlockTransform>(BlockTransform::length_for(sampled_rows_));
  const LogRows rows{result_.first_log_rad + light.first_log_per_mm - guard * step, light.log_step,
                     decimation, sampled_rows_};
  samples_ = std::make_unique<RaySamples>(field, band, rows);
  result_.theta_scale_rad = std::exp(samples_->log_scale_per_mm() - light.first_log_per_mm);
  set_factors(light, decimation, guard * decimation);
}

/// The transforms of the light's weights, for the correlation result[j] = sum over i of weights[i]
/// samples[i + j].
void RayConvolution::set_factors(const LogSpectrum& light, int decimation, int first_tap) {
  const int length = transform_->length(), fine_length = length * decimation;
  const FourierTransform transform(FourierTransform::Kind::real_to_complex, fine_length);
  AlignedBuffer<float> weights(static_cast<std::size_t>(fine_length));
  AlignedBuffer<std::complex<float>> frequencies(static_cast<std::size_t>(fine_length / 2 + 1));
  const int half = length / 2;
  std::vector<float> left(static_cast<std::size_t>(half + 1));
  const DecimationFilter filter(decimation);
  for (int k = 0; k <= half; ++k)
    left[k] = static_cast<float>(filter.response(static_cast<double>(k) / fine_length) * length);
  for (int c = 0; c < 3; ++c) {
    std::fill(weights.values().begin(), weights.values().end(), 0.0f);
    for (std::size_t i = 0; i < light.weights.size(); ++i)
      weights.values()[static_cast<std::size_t>(first_tap) + i] = static_cast<float>(
          light.weights[i][c] *
          std::exp(-RaySamples::kWhitening * light.log_step * static_cast<double>(i)));
    transform.execute(weights, frequencies);
    factors_[c].assign(static_cast<std::size_t>(length), {0, 0});
    for (int k = 0; k < half; ++k) {
      const auto factor = std::conj(frequencies.values()[k]) / left[k];
      factors_[c][k] = factor;
      if (k > 0) factors_[c][length - k] = std::conj(factor);
    }
    factors_[c][half] = frequencies.values()[half].real() / left[half];
  }
}

void RayConvolution::compute_tile(int tile, Workspace& work) const {
  const auto length = static_cast<std::size_t>(transform_->length());
  constexpr std::size_t kStride = kSignals * kBlocksPerTile;
  const auto sampled = work.sampled.values(length * kStride);
  samples_->sample(result_.first_ray + tile * RaySamples::kRaysPerTile, work.samples,
                   reinterpret_cast<float*>(sampled.data()));
  std::fill(sampled.begin() + static_cast<std::ptrdiff_t>(sampled_rows_ * kStride), sampled.end(),
            0.0f);

  const auto product = work.product.values(length * kSignals);
  const int end = std::min(result_.blocks, (tile + 1) * kBlocksPerTile);
  for (int block = tile * kBlocksPerTile; block < end; ++block) {
    const auto spectrum = transform_->forward(sampled.data() + (block % kBlocksPerTile) * kSignals,
                                              kStride, work.spectrum_a, work.spectrum_b);
    for (int c = 0; c < 3; ++c) {
      multiply_rows(factors_[c], spectrum.data(), product.data());
      const auto convolved =
          transform_->backward(product.data(), kSignals, work.result_a, work.result_b);
      std::copy_n(reinterpret_cast<const float*>(convolved.data()), result_.block_size(),
                  result_.block(c, block).begin());
    }
  }
}

}  // namespace glare
