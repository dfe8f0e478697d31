#include "support/apertures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glare::test {
namespace {

// The centre of a pixel.
Place pixel_center(const Frame& frame, int x, int y) {
  return {(x + 0.5) * frame.pixel_mm() - frame.width_mm / 2,
          (y + 0.5) * frame.pixel_mm() - frame.height_mm() / 2};
}

// The mean of transmittance(place) over 16 x 16 points of the pixel around `center`.
template <typename Transmittance>
double pixel_mean(const Place& center, double pixel_mm, const Transmittance& transmittance) {
  constexpr int kPoints = 16;
  double sum = 0;
  for (int j = 0; j < kPoints; ++j) {
    for (int i = 0; i < kPoints; ++i) {
      sum += transmittance(Place{center.x_mm + ((i + 0.5) / kPoints - 0.5) * pixel_mm,
                                 center.y_mm + ((j + 0.5) / kPoints - 0.5) * pixel_mm});
    }
  }
  return sum / (kPoints * kPoints);
}

// An aperture whose sample at (x, y) is value(x, y).
template <typename Value>
Aperture painted(const Frame& frame, const Value& value) {
  Aperture out{Image<float>(frame.width_px, frame.height_px), frame.width_mm};
  for (int y = 0; y < frame.height_px; ++y) {
    for (int x = 0; x < frame.width_px; ++x) {
      out.transmittance(x, y) = static_cast<float>(value(x, y));
    }
  }
  return out;
}

// Open where signed_distance_mm(place) < 0. Only pixels near the edge are looked at closely: the
// function must grow by no more than about the distance moved.
template <typename SignedDistance>
Aperture filled(const Frame& frame, const SignedDistance& signed_distance_mm) {
  return painted(frame, [&](int x, int y) {
    const Place center = pixel_center(frame, x, y);
    const double distance = signed_distance_mm(center);
    if (std::abs(distance) > frame.pixel_mm()) return distance < 0 ? 1.0 : 0.0;
    return pixel_mean(center, frame.pixel_mm(),
                      [&](const Place& at) { return signed_distance_mm(at) < 0 ? 1.0 : 0.0; });
  });
}

double distance_to_disc(const Place& at, const Place& center, double radius_mm) {
  return std::hypot(at.x_mm - center.x_mm, at.y_mm - center.y_mm) - radius_mm;
}

// The share of [middle - pixel / 2, middle + pixel / 2] that lies within `half_width` of `center`.
double interval_share(double middle, double pixel, double center, double half_width) {
  const double begin = std::max(middle - pixel / 2, center - half_width);
  const double end = std::min(middle + pixel / 2, center + half_width);
  return std::max(0.0, end - begin) / pixel;
}

// The open length of bars of half a pitch from 0 to x, counted backwards below 0.
double open_length(double x, double pitch) {
  const double whole = std::floor(x / pitch);
  return whole * pitch / 2 + std::min(x - whole * pitch, pitch / 2);
}

struct Hair {
  Place root, tip;
  double root_half_width_mm, tip_half_width_mm;
};

// Below 0 inside the hair.
double distance_to_hair(const Place& at, const Hair& hair) {
  const double dx = hair.tip.x_mm - hair.root.x_mm, dy = hair.tip.y_mm - hair.root.y_mm;
  const double along =
      ((at.x_mm - hair.root.x_mm) * dx + (at.y_mm - hair.root.y_mm) * dy) / (dx * dx + dy * dy);
  const double share = std::clamp(along, 0.0, 1.0);
  const Place nearest{hair.root.x_mm + share * dx, hair.root.y_mm + share * dy};
  const double half_width = (1 - share) * hair.root_half_width_mm + share * hair.tip_half_width_mm;
  return distance_to_disc(at, nearest, half_width);
}

// Rooted above the disc, fanning out, of uneven lengths.
std::array<Hair, 8> lashes(double radius_mm) {
  constexpr std::array<double, 8> kRootX{-0.72, -0.54, -0.33, -0.13, 0.10, 0.30, 0.53, 0.74};
  constexpr std::array<double, 8> kTipX{-0.88, -0.68, -0.40, -0.20, 0.17, 0.36, 0.71, 0.86};
  constexpr std::array<double, 8> kTipY{-0.18, -0.30, -0.12, -0.37, -0.21, -0.08, -0.33, -0.15};
  std::array<Hair, 8> out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = {{kRootX[i] * radius_mm, -1.1 * radius_mm},
              {kTipX[i] * radius_mm, kTipY[i] * radius_mm},
              0.02 * radius_mm,
              0.004 * radius_mm};
  }
  return out;
}

// u and v run from 0 to 1 across and down the picture.
double letter_f(double u, double v) {
  const bool stem = u > 0.12 && u < 0.24 && v > 0.10 && v < 0.86;
  const bool arm = u > 0.12 && u < 0.62 && v > 0.10 && v < 0.22;
  const bool bar = u > 0.12 && u < 0.47 && v > 0.40 && v < 0.50;
  return stem || arm || bar ? 1.0 : 0.0;
}

// A right-angled triangle, from 0.2 at its left to 0.9 at its right.
double grey_wedge(double u, double v) {
  const double across = (u - 0.40) / 0.52;
  const bool inside = across > 0 && across < 1 && v < 0.93 && v > 0.93 - 0.34 * across;
  return inside ? 0.2 + 0.7 * across : 0.0;
}

}  // namespace

Aperture circle(const Frame& frame, double diameter_mm, const Place& center) {
  return filled(frame,
                [&](const Place& at) { return distance_to_disc(at, center, diameter_mm / 2); });
}

Aperture rectangle(const Frame& frame, double width_mm, double height_mm, const Place& center) {
  const double pixel = frame.pixel_mm();
  return painted(frame, [&](int x, int y) {
    const Place at = pixel_center(frame, x, y);
    return interval_share(at.x_mm, pixel, center.x_mm, width_mm / 2) *
           interval_share(at.y_mm, pixel, center.y_mm, height_mm / 2);
  });
}

Aperture square(const Frame& frame, double side_mm, const Place& center) {
  return rectangle(frame, side_mm, side_mm, center);
}

Aperture slit(const Frame& frame, double width_mm) {
  return rectangle(frame, width_mm, 0.8 * frame.height_mm());
}

Aperture grating(const Frame& frame, double pitch_mm) {
  const double pixel = frame.pixel_mm();
  const double half_width = 0.4 * frame.width_mm, half_height = 0.4 * frame.height_mm();
  return painted(frame, [&](int x, int y) {
    const Place at = pixel_center(frame, x, y);
    const double begin = std::clamp(at.x_mm - pixel / 2, -half_width, half_width);
    const double end = std::clamp(at.x_mm + pixel / 2, -half_width, half_width);
    const double share = (open_length(end, pitch_mm) - open_length(begin, pitch_mm)) / pixel;
    return std::clamp(share, 0.0, 1.0) * interval_share(at.y_mm, pixel, 0, half_height);
  });
}

Aperture lashed_pupil(const Frame& frame, double diameter_mm) {
  const std::array<Hair, 8> hairs = lashes(diameter_mm / 2);
  return filled(frame, [&](const Place& at) {
    double distance = distance_to_disc(at, {}, diameter_mm / 2);
    for (const Hair& hair : hairs) distance = std::max(distance, -distance_to_hair(at, hair));
    return distance;
  });
}

Aperture lopsided(const Frame& frame) {
  return painted(frame, [&](int x, int y) {
    return pixel_mean(pixel_center(frame, x, y), frame.pixel_mm(), [&](const Place& at) {
      const double u = at.x_mm / frame.width_mm + 0.5, v = at.y_mm / frame.height_mm() + 0.5;
      return std::max(letter_f(u, v), grey_wedge(u, v));
    });
  });
}

}  // namespace glare::test
