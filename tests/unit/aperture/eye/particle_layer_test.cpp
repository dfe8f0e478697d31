#include "glare/aperture/eye/particle_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "glare/base/error.h"
#include "glare/base/image.h"

namespace glare {
namespace {

constexpr double width_mm = 2;

ParticleParameters no_particles() { return {{0, 10, 0, 0}, {0, 1, 0, 0}, {0, 20, 0, 0}}; }

ParticleParameters only_lens(const MediumParticles& particles) {
  ParticleParameters parameters = no_particles();
  parameters.lens = particles;
  return parameters;
}

/// The layer in front of an open square, which the particles' disc holds.
Image<float> drawn(const ParticleLayer& layer, int size) {
  Image<float> image(size, size);
  std::ranges::fill(image.values(), 1.0f);
  for (int y = 0; y < size; ++y)
    layer.draw_row({size, width_mm / size}, y, {0, size}, image.row(y));
  return image;
}

double mean(const Image<float>& image) {
  double sum = 0;
  for (const float t : image.values()) sum += t;
  return sum / static_cast<double>(image.values().size());
}

/// Area of the discs whose centres lie in the picture, as share of the picture.
double disc_area_share(const ParticleLayer& layer) {
  double sum = 0;
  for (int i = 0; i < ParticleLayer::medium_count; ++i)
    for (const Disc& disc : layer.medium(i))
      if (std::abs(disc.x) < 0.5 * width_mm && std::abs(disc.y) < 0.5 * width_mm)
        sum += std::numbers::pi * disc.radius * disc.radius;
  return sum / (width_mm * width_mm);
}

int overlapping_pairs(std::span<const Disc> discs) {
  int count = 0;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size() && discs[j].y < discs[i].y + 0.03f; ++j)
      if (std::hypot(discs[i].x - discs[j].x, discs[i].y - discs[j].y) <
          discs[i].radius + discs[j].radius)
        ++count;
  return count;
}

TEST(Particles, AreAsManyAndAsLargeAsAskedFor) {
  const MediumParticles particles{3000, 4, 0.3, 0};
  const ParticleLayer layer(only_lens(particles), 7, 0, 3);
  double area = 0;
  for (const Disc& disc : layer.medium(1)) area += std::numbers::pi * disc.radius * disc.radius;
  const double plane = std::numbers::pi * 9, count = static_cast<double>(layer.medium(1).size());
  // 85000 of them: 0.3 % is their number's standard deviation if it were Poisson's.
  EXPECT_NEAR(count / (3000 * plane), 1, 0.01);
  EXPECT_NEAR(area / (area_share(particles) * plane), 1, 0.02);
  EXPECT_TRUE(layer.medium(0).empty());
}

TEST(Particles, VolumeFractionGivesTheirNumber) {
  // A sphere of 2 um has 4.18879e-9 mm3.
  EXPECT_NEAR(particles_per_mm2(4.18879e-6, 4, 2, 0), 4000, 0.01);
  const MediumParticles lens = ParticleParameters().lens;
  EXPECT_NEAR(particles_per_mm2(6e-6, 4, lens.diameter_um, lens.diameter_spread),
              lens.number_per_mm2, 0.01 * lens.number_per_mm2);
}

TEST(Particles, DarkenByTheirArea) {
  const ParticleLayer layer(only_lens({500, 5, 0.3, 0}), 3, 0, 1.5);
  // 2000 discs cover 1 %. Those on the picture's edges and overlaps are a few tenths of a percent
  // of that.
  const double share = disc_area_share(layer);
  for (const int size : {50, 317, 2000})
    EXPECT_NEAR((1 - mean(drawn(layer, size))) / share, 1, 0.01);
}

TEST(Particles, AverageOfFourPixelsIsThePictureAtHalfTheResolution) {
  const ParticleLayer layer(only_lens({2000, 3, 0.4, 0}), 3, 0, 1.5);
  const Image<float> fine = drawn(layer, 1000), coarse = drawn(layer, 500);
  int differing = 0;
  for (int y = 0; y < 500; ++y)
    for (int x = 0; x < 500; ++x) {
      const float average = 0.25f * (fine(2 * x, 2 * y) + fine(2 * x + 1, 2 * y) +
                                     fine(2 * x, 2 * y + 1) + fine(2 * x + 1, 2 * y + 1));
      // float's rounding of an area relative to the disc's place.
      if (std::abs(average - coarse(x, y)) > 1e-5) ++differing;
    }
  // Where two discs overlap, a fine pixel is opaque before a coarse one is. A pair's overlap is
  // smaller than a pixel: it touches four at most.
  EXPECT_LT(differing, 4 * overlapping_pairs(layer.medium(1)));
  EXPECT_LT(differing, 0.002 * 500 * 500);
}

TEST(Particles, AreTheSameForTheSameSeedOnly) {
  const ParticleParameters parameters = only_lens({2000, 3, 0.4, 0.2});
  const auto picture = [&](std::uint64_t seed, double time_s) {
    return drawn(ParticleLayer(parameters, seed, time_s, 1.5), 200);
  };
  EXPECT_TRUE(std::ranges::equal(picture(1, 2).values(), picture(1, 2).values()));
  EXPECT_FALSE(std::ranges::equal(picture(1, 2).values(), picture(2, 2).values()));
  EXPECT_FALSE(std::ranges::equal(picture(1, 2).values(), picture(1, 2.1).values()));
}

TEST(Particles, StayTheSameWhenThePupilWidens) {
  const ParticleParameters parameters = only_lens({2000, 3, 0.4, 0.2});
  const Image<float> small = drawn(ParticleLayer(parameters, 1, 3, 1.5), 200);
  const Image<float> wide = drawn(ParticleLayer(parameters, 1, 3, 3.7), 200);
  EXPECT_TRUE(std::ranges::equal(small.values(), wide.values()));
}

TEST(Particles, OfTheVitreousDriftAndTheOthersStay) {
  const ParticleParameters parameters;  // The vitreous drifts at 0.2 mm/s.
  const ParticleLayer now(parameters, 1, 10, 2), later(parameters, 1, 60, 2);
  const auto same = [](const Disc& a, const Disc& b) { return a.x == b.x && a.y == b.y; };
  EXPECT_TRUE(std::ranges::equal(now.medium(0), later.medium(0), same));
  EXPECT_TRUE(std::ranges::equal(now.medium(1), later.medium(1), same));
  EXPECT_FALSE(std::ranges::equal(now.medium(2), later.medium(2), same));
}

TEST(Particles, DriftAtTheSpeedAskedForWithoutJumps) {
  // So few that a particle is known by being the nearest.
  const ParticleParameters parameters = only_lens({2, 20, 0, 0.5});
  constexpr double step_s = 0.01;
  double squares = 0, longest = 0;
  int count = 0;
  for (int moment = 0; moment < 20; ++moment) {
    const ParticleLayer now(parameters, 5, 7.3 * moment, 4);
    const ParticleLayer later(parameters, 5, 7.3 * moment + step_s, 5);
    for (const Disc& disc : now.medium(1)) {
      double nearest = 1e30;
      for (const Disc& other : later.medium(1))
        nearest = std::min(nearest, std::hypot<double>(disc.x - other.x, disc.y - other.y));
      squares += nearest * nearest;
      longest = std::max(longest, nearest);
      ++count;
    }
  }
  // 2000 samples; 4 % is some standard deviations of their mean.
  EXPECT_NEAR(std::sqrt(squares / count) / step_s, 0.5, 0.02);
  // Two sines' peaks along both axes are twice the root mean square along each, and 5 um in 10 ms
  // against 700 um between neighbours leaves no doubt who is who.
  EXPECT_LT(longest / step_s, 2 * 0.5 * 1.01);
}

TEST(Particles, RefuseWhatIsOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const MediumParticles bad :
       {MediumParticles{-1, 1, 0, 0}, MediumParticles{20001, 1, 0, 0},
        MediumParticles{nan, 1, 0, 0}, MediumParticles{1, 0.1, 0, 0}, MediumParticles{1, 201, 0, 0},
        MediumParticles{1, 1, -0.1, 0}, MediumParticles{1, 1, 0.7, 0}, MediumParticles{1, 1, 0, -1},
        MediumParticles{1, 1, 0, 1.1}, MediumParticles{20000, 5, 0, 0}})  // Covers 39 %.
    EXPECT_THROW(ParticleLayer(only_lens(bad), 1, 0, 1), OptionError);
  EXPECT_THROW(ParticleLayer({}, 1, nan, 1), OptionError);
  EXPECT_NO_THROW(require_valid(ParticleParameters()));
}

}  // namespace
}  // namespace glare
