// The integral over wavelength along rays: a convolution over the logarithm of the distance.
// Internal.
#pragma once

#include <array>
#include <complex>
#include <memory>
#include <span>
#include <vector>

#include "glare/diffraction/far_field.h"
#include "glare/diffraction/fourier_transform.h"
#include "glare/integration/block_transform.h"
#include "glare/integration/log_spectrum.h"
#include "glare/integration/ray_band.h"
#include "glare/integration/ray_samples.h"

namespace glare {

/// X, Y, Z on the rays of a band, at points and not yet as means, each times
/// (theta / theta_scale_rad)^kWhitening (`RaySamples`).
struct RayXyz {
  double first_log_rad = 0;  ///< ln of the major coordinate in row 0.
  double log_step = 0;
  int rows = 0;
  double theta_scale_rad = 0;
  double ray_step = 0;
  int first_ray = 0;
  int blocks = 0;
  /// [channel][block][row][ray in block]
  std::span<float> values;

  std::size_t block_size() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(kRaysPerBlock);
  }
  std::span<float> block(int channel, int index) const {
    return values.subspan(static_cast<std::size_t>(channel * blocks + index) * block_size(),
                          block_size());
  }
};

/// The rays of one band, which are done tile by tile.
class RayConvolution {
 public:
  /// Rows of the result beyond the band at either end, for interpolation.
  static constexpr int kMarginRows = WindowedSinc::kMostTaps / 2;

  /// Memory for one tile at a time.
  struct Workspace {
    BlockTransform::Buffer sampled, product, spectrum_a, spectrum_b, result_a, result_b;
    RaySamples::Workspace samples;
  };

  /// How many values the result has.
  static std::size_t value_count(const RayBand& band);

  /// `light` is at the band's fine step; `memory` holds `value_count` values, for the result.
  RayConvolution(const FarField& field, const RayBand& band, const LogSpectrum& light,
                 std::span<float> memory);

  int tile_count() const { return (result_.blocks + kBlocksPerTile - 1) / kBlocksPerTile; }
  /// Tiles may be computed at the same time.
  void compute_tile(int tile, Workspace& work) const;
  const RayXyz& result() const { return result_; }

 private:
  static constexpr int kBlocksPerTile = RaySamples::kRaysPerTile / kRaysPerBlock;

  static RayXyz layout(const RayBand& band);
  void set_factors(const LogSpectrum& light, int decimation, int first_tap);

  std::array<std::vector<std::complex<float>>, 3> factors_;
  std::unique_ptr<RaySamples> samples_;
  int sampled_rows_ = 0;
  std::unique_ptr<BlockTransform> transform_;
  RayXyz result_;
};

}  // namespace glare
