// The ciliary corona and the lenticular halo: their angular radii in the template.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "glare/aperture/coverage.h"
#include "glare/aperture/eye/lens_layer.h"
#include "glare/aperture/eye/particle_layer.h"
#include "glare/template/make_template.h"

namespace glare {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// A round pupil's outline.
Outline disc(double diameter_mm) {
  constexpr int corners = 8192;
  std::vector<Point> vertices;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    vertices.push_back(diameter_mm / 2 * Point{std::cos(angle), std::sin(angle)});
  }
  return Outline(vertices);
}

template <typename Layer>
Aperture pupil_behind(const Layer& layer, double diameter_mm, double pixel_mm) {
  Aperture aperture;
  const int size = static_cast<int>(std::ceil(1.04 * diameter_mm / pixel_mm));
  aperture.width_mm = size * pixel_mm;
  aperture.transmittance = Image<float>(size, size);
  const Grid grid{size, pixel_mm};
  const Outline pupil = disc(diameter_mm);
  RowCoverage coverage(size);
  for (int y = 0; y < size; ++y) {
    if (!pupil.cover_row(grid, y, coverage)) continue;
    const std::span<float> row = aperture.transmittance.row(y);
    coverage.paint([&](int first, int last, float share) {
      std::fill(row.begin() + first, row.begin() + last, share);
    });
    layer.draw_row(grid, y, {0, size}, row);
  }
  return aperture;
}

/// Mean luminance per steradian in rings `pitch` wide around the axis, of a lamp of one wavelength.
std::vector<double> radial_profile(const Aperture& aperture, double wavelength_nm, double fov_deg) {
  TemplateOptions options;
  options.width = options.height = 300;
  options.field_of_view_deg = fov_deg;
  options.normalization = Normalization::absolute;
  const Spectrum lamp({wavelength_nm - 2, wavelength_nm, wavelength_nm + 2}, {0, 1, 0});
  const GlareTemplate glare = make_template(aperture, lamp, options);
  std::vector<double> sums(150), counts(150);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x) {
      const auto ring = static_cast<std::size_t>(std::hypot(x - 150, y - 150) + 0.5);
      if (ring >= sums.size()) continue;
      sums[ring] += glare.luminance(x, y);
      counts[ring] += 1;
    }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
  return sums;
}

/// Radius of the brightest ring from `from_deg` outwards.
double peak_deg(const std::vector<double>& profile, double fov_deg, double from_deg) {
  const double pitch = fov_deg / 300;
  auto best = static_cast<std::size_t>(from_deg / pitch);
  for (std::size_t i = best; i < profile.size(); ++i)
    if (profile[i] > profile[best]) best = i;
  return static_cast<double>(best) * pitch;
}

double halo_deg(const Aperture& aperture, double wavelength_nm, double fov_deg) {
  return peak_deg(radial_profile(aperture, wavelength_nm, fov_deg), fov_deg, 1.2);
}

TEST(LenticularHalo, LiesAtTheFibresFirstOrder) {
  LensParameters lens;
  for (const double pitch_um : {10.85, 8.0}) {
    lens.fibre_pitch_um = pitch_um;
    const Aperture eye = pupil_behind(LensLayer(lens, 1), 6, 0.0022);
    for (const double wavelength_nm : {450.0, 568.0, 650.0}) {
      const double expected = 1e-3 * wavelength_nm / pitch_um * degrees;
      // The ring is 12.5 % wide; its inner side is a little brighter.
      EXPECT_NEAR(halo_deg(eye, wavelength_nm, 11) / expected, 1, 0.05);
    }
  }
}

TEST(LenticularHalo, IsAtThePublishedRadius) {
  // 3 degrees at 568 nm (Spencer and others 1995), within half the ring's width.
  const Aperture eye = pupil_behind(LensLayer({}, 1), 6, 0.0025);
  EXPECT_NEAR(halo_deg(eye, 568, 10), 3, 0.19);
}

TEST(LenticularHalo, NeedsAWidePupil) {
  const auto contrast = [](double diameter_mm) {
    const auto profile =
        radial_profile(pupil_behind(LensLayer({}, 1), diameter_mm, 0.0025), 568, 10);
    return profile[90] / profile[110];  // 3.0 degrees over 3.7.
  };
  EXPECT_GT(contrast(6), 5);
  EXPECT_LT(contrast(1.9), 3);  // As a bare pupil's: its own falls as the cube of the angle.
}

/// Where the light of particles of one diameter has fallen to half of what it is on the axis: of
/// particles that cover `share` of the pupil, share (pi d^2 / 4) / wavelength^2 per steradian.
double half_width_deg(double diameter_um) {
  ParticleParameters particles;
  const double share = 0.02;
  particles.cornea.number_per_mm2 = particles.vitreous.number_per_mm2 = 0;
  particles.lens = {share / (std::numbers::pi / 4 * diameter_um * diameter_um * 1e-6), diameter_um,
                    0, 0};
  const double fov_deg = 12;
  const auto profile =
      radial_profile(pupil_behind(ParticleLayer(particles, 1, 0, 3.1), 6, 0.0022), 550, fov_deg);
  const double axis =
      share * std::numbers::pi / 4 * std::pow(diameter_um / 0.55, 2);  // Wavelength in um.
  std::size_t i = 0;
  while (i < profile.size() && profile[i] > 0.5 * axis) ++i;
  return static_cast<double>(i) * fov_deg / 300;
}

TEST(CiliaryCorona, ExtendsAsTheInverseOfTheParticlesDiameter) {
  for (const double diameter_um : {6.0, 9.0, 12.0}) {
    // Airy's pattern is half its maximum at 0.514 wavelength / d. A ring of pixels is 0.04 degrees
    // wide, and its mean over some hundred speckles is uncertain by 5 %.
    const double expected = 0.514 * 0.55 / diameter_um * degrees;
    EXPECT_NEAR(half_width_deg(diameter_um), expected, 0.05 * expected + 0.04);
  }
}

}  // namespace
}  // namespace glare
