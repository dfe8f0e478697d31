#include "glare/aperture/eye/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glare {
namespace {

TEST(Motion, AtTimeZeroTheEyeIsAtRest) {
  for (std::uint64_t seed = 1; seed < 50; ++seed) {
    EyeParameters eye;
    eye.seed = seed;
    EXPECT_EQ(pupil_diameter_at_mm(eye, 0), eye.pupil.diameter_mm);
    EXPECT_EQ(lid_closure_at(eye, 0), 0);
  }
}

TEST(Motion, PupilWandersByItsRootMeanSquare) {
  EyeParameters eye;
  eye.motion.hippus_mm = 0.1;
  double squares = 0, largest = 0, sum = 0;
  constexpr int count = 200000;
  for (int i = 0; i < count; ++i) {
    const double off = pupil_diameter_at_mm(eye, 0.1 * i) - eye.pupil.diameter_mm;
    sum += off;
    squares += off * off;
    largest = std::max(largest, std::abs(off));
  }
  EXPECT_NEAR(sum / count, 0, 0.005);  // of waves that last up to 20 s, over 20000 s
  // The limit of three times takes a percent, and 32 waves for that time leave another.
  EXPECT_NEAR(std::sqrt(squares / count), 0.1, 0.003);
  EXPECT_LT(largest, largest_pupil_diameter_mm(eye) - eye.pupil.diameter_mm);
}

TEST(Motion, PupilMovesSmoothly) {
  const EyeParameters eye;
  // Waves of up to 2 Hz, most of them below 0.5 Hz, of 0.08 mm in all: some 0.1 mm/s.
  for (double t = 0; t < 60; t += 0.01)
    EXPECT_LT(std::abs(pupil_diameter_at_mm(eye, t + 0.01) - pupil_diameter_at_mm(eye, t)), 0.01)
        << t;
}

TEST(Motion, BlinksAsOftenAsAskedForAndSmoothly) {
  EyeParameters eye;
  for (const double per_minute : {5.0, 15.0, 40.0}) {
    eye.motion.blinks_per_minute = per_minute;
    int blinks = 0;
    double closed_s = 0, previous = 0;
    constexpr double step_s = 0.002, end_s = 1200;
    for (int i = 0; i * step_s < end_s; ++i) {
      const double closure = lid_closure_at(eye, i * step_s);
      ASSERT_GE(closure, 0);
      ASSERT_LE(closure, 1);
      // Closing takes 0.1 s: at most pi / 2 / 0.1 s of closure.
      EXPECT_LT(std::abs(closure - previous), 0.033) << i * step_s;
      blinks += previous < 0.5 && closure >= 0.5;
      closed_s += closure > 0.999 ? step_s : 0;
      previous = closure;
    }
    EXPECT_EQ(blinks, per_minute * end_s / 60);
    EXPECT_GT(closed_s / blinks, 0.05);
    EXPECT_LT(closed_s / blinks, 0.07);
  }
}

TEST(Motion, BlinksAreIrregularAndCanBeTurnedOff) {
  EyeParameters eye;
  double earliest = 1e9, latest = 0;  // Start in its 4 s.
  for (int blink = 0; blink < 50; ++blink) {
    double t = 0;
    while (lid_closure_at(eye, 4 * blink + t) == 0) t += 0.01;
    earliest = std::min(earliest, t);
    latest = std::max(latest, t);
  }
  EXPECT_LT(earliest, 0.5);
  EXPECT_GT(latest, 2);
  eye.motion.blinks_per_minute = 0;
  for (double t = 0; t < 60; t += 0.05) EXPECT_EQ(lid_closure_at(eye, t), 0);
}

/// Open area at a time, and how much of the picture changes within a thousandth of a second.
TEST(Motion, PictureIsAContinuousFunctionOfTime) {
  EyeParameters eye;
  for (const double time_s : {0.0, 0.5, 1.7, 3.2, 13.0}) {
    eye.time_s = time_s;
    const Aperture before = draw_eye(eye, 0.05);
    eye.time_s = time_s + 1e-3;
    const Aperture after = draw_eye(eye, 0.05);
    ASSERT_EQ(before.transmittance.width(), after.transmittance.width());
    double change = 0, open = 0;
    for (std::size_t i = 0; i < before.transmittance.values().size(); ++i) {
      change += std::abs(before.transmittance.values()[i] - after.transmittance.values()[i]);
      open += before.transmittance.values()[i];
    }
    // The lid passes 7.9 mm in 0.1 s: 0.12 mm of 6.5 in a millisecond, and the lashes with it.
    EXPECT_LT(change, 0.05 * std::max(open, 100.0)) << time_s;
  }
}

TEST(Motion, ABlinkClosesTheEye) {
  EyeParameters eye;
  double t = 0;
  while (lid_closure_at(eye, t) < 1) t += 0.01;
  eye.time_s = t;
  const Aperture closed = draw_eye(eye, 0.05);
  for (const float value : closed.transmittance.values()) ASSERT_EQ(value, 0);
  const double width_mm = eye_picture_width_mm(eye);
  eye.time_s = 0;
  EXPECT_EQ(eye_picture_width_mm(eye), width_mm);
}

}  // namespace
}  // namespace glare
