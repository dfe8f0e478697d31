#include "support/bins_pitch_case.h"

#include <utility>

#include "support/apertures.h"

namespace glare::test {

namespace {

constexpr double kWidth_mm = 8;
constexpr double kWavelength_mm = 560e-6;

}  // namespace

BinsPitchCase::BinsPitchCase(int output, int transform_length)
    : aperture(lashed_pupil({transform_length / 4, transform_length / 4, kWidth_mm}, kWidth_mm)),
      grid{output, output, kWavelength_mm / (transform_length * aperture.pixel_mm())} {}

FarField BinsPitchCase::field(int threads) const {
  FarFieldRequest request = far_field_request(kWidth_mm, grid, range);
  request.threads = threads;
  return far_field(aperture, request);
}

exact::PixelRequest BinsPitchCase::request(std::vector<exact::Pixel> pixels) const {
  return {grid.width, grid.height, grid.pitch_rad, std::move(pixels), range.lo_nm, range.hi_nm};
}

}  // namespace glare::test
