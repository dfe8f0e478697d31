// Drawing the eye's particles by area. Internal.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glare/aperture/coverage.h"
#include "glare/aperture/eye/particles.h"

namespace glare {

/// An opaque disc, in mm from the pupil's centre, x to the right and y down.
struct Disc {
  float x, y, radius;
};

/// The eye's particles at one moment. The same seed and time give the same particles on every
/// machine; they move continuously with time, and one medium's don't depend on another's.
class ParticleLayer {
 public:
  /// Particles that touch the disc of `radius_mm` around the pupil's centre. Throws `OptionError`
  /// for parameters that `require_valid` refuses, and for a time that isn't finite.
  ParticleLayer(const ParticleParameters& parameters, std::uint64_t seed, double time_s,
                double radius_mm);

  /// Multiplies row `y` of the picture inside `open` by the share of each pixel's square that no
  /// particle covers. Exact (areas to 2e-8 of the squared radius), except where particles overlap:
  /// there they count twice, but a pixel is never more than opaque. Several threads may draw at
  /// once.
  void draw_row(const Grid& grid, int y, Columns open, std::span<float> row) const;

  /// One medium's particles (0 cornea, 1 lens, 2 vitreous), from the top downwards.
  std::span<const Disc> medium(int index) const { return media_[index].discs; }
  static constexpr int medium_count = 3;

 private:
  struct Medium {
    std::vector<Disc> discs;
    float max_radius = 0;
  };
  static Medium place(const MediumParticles& particles, std::uint64_t seed, double time_s,
                      double radius_mm);

  Medium media_[medium_count];
};

}  // namespace glare
