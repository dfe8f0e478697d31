// The far field on rays from the axis, over the logarithm of the frequency. Internal.
#pragma once

#include <memory>
#include <vector>

#include "glare/diffraction/far_field.h"
#include "glare/integration/ray_band.h"
#include "glare/integration/vector_loops.h"

namespace glare {

/// Rows over the logarithm of the major frequency; row 0 is at `first_log_per_mm`.
struct LogRows {
  double first_log_per_mm = 0;
  double fine_step = 0;  ///< At which the far field is interpolated,
  int decimation = 1;    ///< of which as many make a step from row to row, which averages.
  int count = 0;

  double step() const { return fine_step * decimation; }
};

/// Averages fine steps where there are more than one to a row: a windowed sinc of four rows either
/// way.
class DecimationFilter {
 public:
  explicit DecimationFilter(int decimation);

  /// Steps on either side that it takes in.
  int reach() const { return static_cast<int>(weights_.size() / 2); }
  double weight(int step) const { return weights_[static_cast<std::size_t>(step + reach())]; }
  /// What it leaves of a cosine of `cycles` a fine step.
  double response(double cycles) const;

 private:
  std::vector<double> weights_;  ///< Their sum is 1.
};

/// Samples a band's rays, in tiles of rays side by side. The pattern is multiplied by
/// (frequency / scale)^kWhitening, about as it falls off, so that all of a band is about as bright
/// and rounding is relative to what is near.
class RaySamples {
 public:
  static constexpr double kWhitening = 3;
  static constexpr int kRaysPerTile = 4 * kRaysPerBlock;

  RaySamples(const FarField& field, const RayBand& band, const LogRows& rows);

  double log_scale_per_mm() const { return log_scale_; }

  /// Memory for one tile at a time.
  struct Workspace {
    std::vector<float> transposed, line, sampled;
  };

  /// Writes rows.count rows of kRaysPerTile values: of the rays from `first_ray` on, 0 beyond the
  /// band's last.
  void sample(int first_ray, Workspace& work, float* result) const;

 private:
  /// Rows of the far field, first and on, that make up one row here.
  struct WeightedRows {
    int first = 0;
    std::vector<float> weights;
    double place = 0;  ///< Where it is, in samples.
  };
  /// Some rows of the far field, along the minor coordinate: row k's sample j is at
  /// rows[(k - row0) * stride + j].
  struct Window {
    const float* rows;
    std::size_t stride;
  };
  void set_weights();
  void sample_by_row(int first_ray, int count, Workspace& work, float* result) const;
  void sample_averaged(int first_ray, int count, Workspace& work, float* result) const;
  void copy_rows(int begin, int end, int row0, int row1, float* target) const;
  void transpose_rows(int begin, int end, int row0, int row1, float* target) const;
  Window window(int first_ray, int count, int row0, int row1, Workspace& work) const;

  const FarField& field_;
  RayBand band_;
  LogRows rows_;
  double major_bin_per_mm_, minor_samples_;  ///< Minor samples per ray and major sample.
  int last_major_;                           ///< The last major sample that the field holds.
  bool fine_ = false;                        ///< Interpolation with more taps.
  double log_scale_ = 0;
  std::vector<WeightedRows> weighted_;
};

}  // namespace glare
