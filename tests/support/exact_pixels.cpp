#include "support/exact_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

#include "glare/base/parallel.h"
#include "support/gridded_intensity.h"

namespace glare::exact {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMmPerNm = 1e-6;

// ---- The integral over wavelength ----

// Four-point Gauss-Legendre: places and weights on an interval from -1 to 1.
constexpr int kPoints = 4;
constexpr double kPlace[kPoints] = {-0.861136311594052575, -0.339981043584856265,
                                    0.339981043584856265, 0.861136311594052575};
constexpr double kWeight[kPoints] = {0.347854845137453857, 0.652145154862546143,
                                     0.652145154862546143, 0.347854845137453857};

// Wavelengths, and what the intensity at theta / lambda adds to X, Y and Z of every lamp.
struct Quadrature {
  std::vector<double> wavelength_nm;
  std::vector<std::vector<Xyz>> weight;  // By lamp, then by wavelength.
};

// The limits and the knots between them: between two, every table is linear.
std::vector<double> knots_of(const PixelRequest& request, const Observer& observer,
                             const std::vector<SpectralTable>& lamps) {
  const double lo = request.lambda_lo_nm, hi = request.lambda_hi_nm;
  if (!(lo < hi)) throw std::invalid_argument("exact pixels: an empty range of wavelengths");
  std::set<double> knots{lo, hi};
  const auto add = [&](const SpectralTable& table) {
    for (const double knot : table.wavelength_nm)
      if (knot > lo && knot < hi) knots.insert(knot);
  };
  for (const SpectralTable& table : observer) add(table);
  for (const SpectralTable& table : lamps) add(table);
  return {knots.begin(), knots.end()};
}

Xyz observed(const Observer& observer, const SpectralTable& lamp, double wavelength_nm) {
  const double power = value_at(lamp, wavelength_nm);
  Xyz out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = power * value_at(observer[c], wavelength_nm);
  return out;
}

// Calls add(wavelength, weight) for each node. The phase of light that goes `path_mm` farther moves
// by at most kPoints * radians over each part of an interval.
template <typename Add>
void for_each_node(const std::vector<double>& knots, double path_mm, double radians,
                   const Add& add) {
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double phase = 2 * kPi * path_mm / kMmPerNm * (1 / knots[i] - 1 / knots[i + 1]);
    const int parts = std::max(1, static_cast<int>(std::ceil(phase / (kPoints * radians))));
    const double half = (knots[i + 1] - knots[i]) / parts / 2;
    for (int part = 0; part < parts; ++part)
      for (int p = 0; p < kPoints; ++p)
        add(knots[i] + (2 * part + 1 + kPlace[p]) * half, kWeight[p] * half);
  }
}

class Light {
 public:
  Light(const PixelRequest& request, const Observer& observer,
        const std::vector<SpectralTable>& lamps)
      : radians_(request.radians_per_wavelength),
        knots_(knots_of(request, observer, lamps)),
        observer_(observer),
        lamps_(lamps) {
    for (const SpectralTable& lamp : lamps) {
      double luminance = 0;  // Exact, since S y-bar is piecewise quadratic.
      for_each_node(knots_, 0, 1, [&](double wavelength_nm, double weight_nm) {
        luminance += weight_nm * observed(observer, lamp, wavelength_nm)[1];
      });
      if (!(luminance > 0)) throw std::invalid_argument("exact pixels: a lamp without luminance");
      luminance_.push_back(luminance);
    }
  }

  // Without the wavelengths that nobody sees of any lamp.
  Quadrature quadrature(double path_mm) const {
    Quadrature out;
    out.weight.resize(lamps_.size());
    for_each_node(knots_, path_mm, radians_, [&](double wavelength_nm, double weight_nm) {
      std::vector<Xyz> weights;
      for (std::size_t l = 0; l < lamps_.size(); ++l) {
        weights.push_back(observed(observer_, lamps_[l], wavelength_nm));
        const double lambda_mm = wavelength_nm * kMmPerNm;
        for (double& w : weights.back()) w *= weight_nm / luminance_[l] / (lambda_mm * lambda_mm);
      }
      if (std::all_of(weights.begin(), weights.end(), [](const Xyz& w) { return w == Xyz{}; }))
        return;
      out.wavelength_nm.push_back(wavelength_nm);
      for (std::size_t l = 0; l < lamps_.size(); ++l) out.weight[l].push_back(weights[l]);
    });
    return out;
  }

 private:
  double radians_;
  std::vector<double> knots_;
  const Observer& observer_;
  const std::vector<SpectralTable>& lamps_;
  std::vector<double> luminance_;
};

// ---- The pixels ----

// From the axis to the pixel's centre.
struct Direction {
  double x_rad, y_rad;
};

Direction direction_of(const Pixel& pixel, const PixelRequest& request) {
  if (pixel.x < 0 || pixel.x >= request.width || pixel.y < 0 || pixel.y >= request.height)
    throw std::invalid_argument("exact pixels: no such pixel");
  return {(pixel.x - request.width / 2) * request.pitch_rad,
          (pixel.y - request.height / 2) * request.pitch_rad};
}

// How much farther light goes from one corner of the aperture than from the opposite one, towards
// the farthest corner of a pixel; rounded up to a few values, for which quadratures are shared.
double path_mm(const Direction& at, const Aperture& aperture, double pitch_rad) {
  constexpr double kStep = 1.2;
  const double path = (std::abs(at.x_rad) + pitch_rad / 2) * aperture.width_mm +
                      (std::abs(at.y_rad) + pitch_rad / 2) * aperture.height_mm();
  return std::pow(kStep, std::ceil(std::log(path) / std::log(kStep)));
}

// XYZ of one pixel for every lamp.
std::vector<Xyz> pixel_xyz(const Direction& at, double pitch_rad, const GriddedIntensity& intensity,
                           const Quadrature& quadrature) {
  std::vector<Xyz> out(quadrature.weight.size(), Xyz{});
  GriddedIntensity::Weights working_memory;
  for (std::size_t n = 0; n < quadrature.wavelength_nm.size(); ++n) {
    const double per_mm = 1 / (quadrature.wavelength_nm[n] * kMmPerNm);
    const double half = pitch_rad / 2;
    const double mean = intensity.mean({(at.x_rad - half) * per_mm, (at.x_rad + half) * per_mm,
                                        (at.y_rad - half) * per_mm, (at.y_rad + half) * per_mm},
                                       working_memory);
    for (std::size_t l = 0; l < out.size(); ++l)
      for (std::size_t c = 0; c < 3; ++c) out[l][c] += mean * quadrature.weight[l][n][c];
  }
  return out;
}

}  // namespace

PixelResult xyz_at(const Aperture& aperture, const PixelRequest& request, const Observer& observer,
                   const std::vector<SpectralTable>& lamps) {
  const Light light(request, observer, lamps);
  std::map<double, Quadrature> quadratures;
  for (const Pixel& pixel : request.pixels) {
    const double path = path_mm(direction_of(pixel, request), aperture, request.pitch_rad);
    if (!quadratures.contains(path)) quadratures.emplace(path, light.quadrature(path));
  }
  const GriddedIntensity intensity(aperture, request.pitch_rad / (request.lambda_lo_nm * kMmPerNm),
                                   request.threads);

  PixelResult out;
  out.xyz.assign(lamps.size(), std::vector<Xyz>(request.pixels.size()));
  parallel_for(static_cast<int>(request.pixels.size()), request.threads, [&](int i) {
    const Direction at = direction_of(request.pixels[i], request);
    const double path = path_mm(at, aperture, request.pitch_rad);
    const auto xyz = pixel_xyz(at, request.pitch_rad, intensity, quadratures.at(path));
    for (std::size_t l = 0; l < lamps.size(); ++l) out.xyz[l][i] = xyz[l];
  });
  if (!quadratures.empty()) {
    out.fewest_wavelengths = static_cast<int>(quadratures.begin()->second.wavelength_nm.size());
    out.most_wavelengths = static_cast<int>(quadratures.rbegin()->second.wavelength_nm.size());
  }
  return out;
}

std::vector<Pixel> spread_pixels(int width, int height, int count, double inner_px,
                                 double outer_px) {
  constexpr int kTries = 64;
  const double golden_angle = kPi * (3 - std::sqrt(5.0));
  std::set<Pixel> taken;
  std::vector<Pixel> out;
  int turn = 0;
  for (int i = 0; i < count; ++i) {
    const double radius = inner_px * std::pow(outer_px / inner_px, (i + 0.5) / count);
    for (int tries = 0; tries < kTries; ++tries) {
      const double angle = golden_angle * turn++;
      const Pixel pixel{width / 2 + static_cast<int>(std::lround(radius * std::cos(angle))),
                        height / 2 + static_cast<int>(std::lround(radius * std::sin(angle)))};
      if (pixel.x < 0 || pixel.x >= width || pixel.y < 0 || pixel.y >= height) continue;
      if (!taken.insert(pixel).second) continue;
      out.push_back(pixel);
      break;
    }
  }
  return out;
}

}  // namespace glare::exact
