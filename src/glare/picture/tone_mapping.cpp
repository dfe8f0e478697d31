// Row by row: the picture's colours in the display's primaries, the curve (from a table where it
// has a power), the chroma put back, and the display's transfer curve.
#include "glare/picture/tone_mapping.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>

#include "glare/base/error.h"
#include "glare/base/parallel.h"
#include "glare/base/range_check.h"
#include "glare/color/gamut.h"
#include "glare/picture/log_table.h"
#include "glare/picture/srgb_encoding.h"

namespace glare {

namespace {

using Rgb = std::array<float, 3>;
using Matrix3f = std::array<Rgb, 3>;

constexpr double kWhite = 255;
constexpr int kBandRows = 16;

void require_valid(const ToneMapping& mapping) {
  constexpr double tiny = 1e-30, huge = 1e30;
  require_in_range("the adaptation luminance", mapping.adaptation_luminance, tiny, huge);
  require_in_range("the tone curve's gamma", mapping.gamma, 0.1, 10);
  require_in_range("the tone curve's k", mapping.k, 1, 1e4);
  require_in_range("the display's maximum", mapping.display_maximum, tiny, 1e4);
  require_in_range("the exposure in stops", mapping.exposure_stops, -100, 100);
}

// The curves.

/// The sigmoid as a share of white. Outside the table it is constant to 1e-6.
LogTable sigmoid_table(const ToneMapping& mapping) {
  const double k = mapping.k, g = mapping.gamma;
  const int octaves = static_cast<int>(std::ceil(std::log2(1e6 * k) / g));
  const int step_bits = 7 + static_cast<int>(std::ceil(std::log2(std::max(1.0, g))));
  return {std::max(-126, -octaves), std::min(127, octaves), step_bits, [&](double x) {
            const double power = std::pow(x, g);
            return mapping.display_maximum / kWhite * (power + 1 / k) / (power + k);
          }};
}

// Colours.

Matrix3f display_matrix(const Picture& picture) {
  const Matrix3 exact =
      lin_rec709_color_space().rgb_from_xyz() * picture.color_space.xyz_from_rgb();
  Matrix3f matrix;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      matrix[row][column] = static_cast<float>(exact[row][column]);
  return matrix;
}

const Vector3& luminance_weights() {
  static const Vector3 weights = lin_rec709_color_space().xyz_from_rgb()[1];
  return weights;
}

/// The colour of `rgb` at another luminance, within what the display can show.
Rgb within_gamut(const Rgb& rgb, float luminance, float shown) {
  const Rgb grey = {shown, shown, shown};
  if (!(luminance > 0 && std::isfinite(luminance))) return grey;
  Rgb unit;
  for (int k = 0; k < 3; ++k)
    unit[k] = static_cast<float>(static_cast<double>(rgb[k]) / static_cast<double>(luminance));
  if (!std::ranges::all_of(unit, [](float value) { return std::isfinite(value); })) return grey;
  return limited_to_white(desaturated_into_gamut(unit, luminance_weights()), shown);
}

using Weights = std::array<float, 3>;

/// A part of a row, a channel at a time: plain loops over these become vectors.
struct Stretch {
  static constexpr int kMost = 512;  // All of it stays in the nearest cache.
  using Values = std::array<float, kMost>;

  std::size_t count = 0;
  std::array<Values, 3> channels;
  Values luminances, shown, factors;           ///< And what takes the one to the other.
  std::array<std::int32_t, kMost> is_outside;  ///< Not a colour that the display can show.
};

class ToneMapper {
 public:
  ToneMapper(const Picture& picture, const ToneMapping& mapping)
      : picture_(picture),
        mapping_(mapping),
        matrix_(display_matrix(picture)),
        sigmoid_(sigmoid_table(mapping)) {
    const double white =
        mapping.curve == ToneMapping::Curve::linear ? 1 : mapping.adaptation_luminance;
    const double scale = std::exp2(mapping.exposure_stops) / white;
    for (Rgb& row : matrix_)
      for (float& value : row) value = static_cast<float>(value * scale);
  }

  void map_row(int y, std::span<Rgb> result) const {
    Stretch stretch;
    for (std::size_t first = 0; first < result.size(); first += Stretch::kMost) {
      stretch.count = std::min<std::size_t>(Stretch::kMost, result.size() - first);
      if (mapping_.application == ToneMapping::Application::luminance)
        map_luminance(y, first, stretch);
      else
        map_channels(y, first, stretch);
      if (mapping_.transfer == ToneMapping::Transfer::srgb)
        for (auto& channel : stretch.channels) encode_srgb(std::span(channel).first(stretch.count));
      for (std::size_t x = 0; x < stretch.count; ++x)
        result[first + x] = {stretch.channels[0][x], stretch.channels[1][x],
                             stretch.channels[2][x]};
    }
  }

 private:
  /// A weighted sum of the picture's channels.
  void sum(int y, std::size_t first, const Weights& weights, std::span<float> result) const {
    const float *const red = picture_.channels[0].row(y).data() + first,
                       *const green = picture_.channels[1].row(y).data() + first,
                       *const blue = picture_.channels[2].row(y).data() + first;
    const auto [r, g, b] = weights;
    for (std::size_t x = 0; x < result.size(); ++x)
      result[x] = r * red[x] + g * green[x] + b * blue[x];
  }

  /// The colours as multiples of L_wa, or of white.
  void to_display_primaries(int y, std::size_t first, Stretch& stretch) const {
    for (std::size_t k = 0; k < 3; ++k)
      sum(y, first, matrix_[k], std::span(stretch.channels[k]).first(stretch.count));
  }

  Weights weights_of_luminance() const {
    const Vector3& w = luminance_weights();
    Weights weights;
    for (std::size_t k = 0; k < 3; ++k)
      weights[k] =
          static_cast<float>(w[0] * matrix_[0][k] + w[1] * matrix_[1][k] + w[2] * matrix_[2][k]);
    return weights;
  }

  /// The curve of each value, in place.
  void apply_curve(std::span<float> values) const {
    const auto scale = static_cast<float>(mapping_.display_maximum / kWhite);
    const auto k = static_cast<float>(mapping_.k), in_the_dark = static_cast<float>(1 / mapping_.k);
    constexpr float huge = 1e30f;
    if (mapping_.curve == ToneMapping::Curve::linear) {
      for (float& x : values) x = std::min(std::max(0.0f, x), 1.0f);
    } else if (mapping_.gamma == 1) {
      for (float& x : values) {
        const float light = std::min(std::max(0.0f, x), huge);
        x = std::min(scale * (light + in_the_dark) / (light + k), 1.0f);
      }
    } else {
      for (float& x : values) x = std::min(sigmoid_(x), 1.0f);
    }
  }

  void map_channels(int y, std::size_t first, Stretch& stretch) const {
    to_display_primaries(y, first, stretch);
    auto& [red, green, blue] = stretch.channels;
    for (std::size_t x = 0; x < stretch.count; ++x)
      if ((red[x] < 0) | (green[x] < 0) | (blue[x] < 0))  // One branch, mostly not taken.
        std::tie(red[x], green[x], blue[x]) = std::tuple_cat(
            desaturated_into_gamut({red[x], green[x], blue[x]}, luminance_weights()));
    for (auto& channel : stretch.channels) apply_curve(std::span(channel).first(stretch.count));
  }

  void map_luminance(int y, std::size_t first, Stretch& stretch) const {
    to_display_primaries(y, first, stretch);
    const std::span luminances = std::span(stretch.luminances).first(stretch.count);
    const std::span shown = std::span(stretch.shown).first(stretch.count);
    sum(y, first, weights_of_luminance(), luminances);
    std::ranges::copy(luminances, shown.begin());
    apply_curve(shown);
    find_outside(stretch);
    auto& [red, green, blue] = stretch.channels;
    for (std::size_t x = 0; x < stretch.count; ++x) {
      if (stretch.is_outside[x] == 0) continue;
      std::tie(red[x], green[x], blue[x]) =
          std::tuple_cat(within_gamut({red[x], green[x], blue[x]}, luminances[x], shown[x]));
      stretch.factors[x] = 1;
    }
    for (auto& channel : stretch.channels)
      for (std::size_t x = 0; x < stretch.count; ++x) channel[x] *= stretch.factors[x];
  }

  static void find_outside(Stretch& stretch) {
    for (std::size_t x = 0; x < stretch.count; ++x)
      stretch.factors[x] = stretch.shown[x] / stretch.luminances[x];
    for (std::size_t x = 0; x < stretch.count; ++x)
      stretch.is_outside[x] = stretch.luminances[x] > 0 ? 0 : 1;
    for (const auto& channel : stretch.channels)
      for (std::size_t x = 0; x < stretch.count; ++x) {
        const std::int32_t is_negative = channel[x] >= 0 ? 0 : 1;
        const std::int32_t is_above_white = channel[x] * stretch.factors[x] <= 1 ? 0 : 1;
        stretch.is_outside[x] |= is_negative | is_above_white;
      }
  }

  const Picture& picture_;
  const ToneMapping& mapping_;
  Matrix3f matrix_;
  LogTable sigmoid_;
};

}  // namespace

Image<Rgb> tone_mapped(const Picture& picture, const ToneMapping& mapping, int threads) {
  require_valid(mapping);
  const ToneMapper mapper(picture, mapping);
  auto result = Image<Rgb>::uninitialized(picture.width(), picture.height());
  const int bands = (picture.height() + kBandRows - 1) / kBandRows;
  parallel_for(bands, threads, [&](int band) {
    const int end = std::min((band + 1) * kBandRows, picture.height());
    for (int y = band * kBandRows; y < end; ++y) mapper.map_row(y, result.row(y));
  });
  return result;
}

}  // namespace glare
