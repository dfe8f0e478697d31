#include "support/color_difference.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace glare::test {
namespace {

double lab_curve(double ratio) {
  constexpr double kLimit = 216.0 / 24389.0;  // (6 / 29)^3
  return ratio > kLimit ? std::cbrt(ratio) : (841.0 / 108.0) * ratio + 4.0 / 29.0;
}

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

double cos_deg(double degrees) { return std::cos(radians(degrees)); }

// Equation 7: in [0, 360), and 0 for a grey.
double hue_deg(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double hue = std::atan2(b, a) * 180 / std::numbers::pi;
  return hue < 0 ? hue + 360 : hue;
}

// sqrt(c^7 / (c^7 + 25^7)), of equations 4 and 17.
double chroma_share(double chroma) {
  const double c7 = std::pow(chroma, 7);
  return std::sqrt(c7 / (c7 + 6103515625.0));
}

// Equation 10: the way round the circle from hue 1 to hue 2, in [-180, 180].
double hue_step_deg(double hue_1, double hue_2) {
  const double step = hue_2 - hue_1;
  if (step > 180) return step - 360;
  if (step < -180) return step + 360;
  return step;
}

// Equation 14, for two colours neither of which is grey.
double mean_hue_deg(double hue_1, double hue_2) {
  const double sum = hue_1 + hue_2;
  if (std::abs(hue_1 - hue_2) <= 180) return sum / 2;
  return sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2;
}

struct LightnessChromaHue {
  double L, C, h;
};

// Equations 2 to 7.
LightnessChromaHue with_stretched_a(const Lab& lab, double g) {
  const double a = (1 + g) * lab.a;
  return {lab.L, std::hypot(a, lab.b), hue_deg(a, lab.b)};
}

// Equation 15.
double hue_weight(double mean_hue) {
  return 1 - 0.17 * cos_deg(mean_hue - 30) + 0.24 * cos_deg(2 * mean_hue) +
         0.32 * cos_deg(3 * mean_hue + 6) - 0.20 * cos_deg(4 * mean_hue - 63);
}

// Equations 16, 17 and 21.
double rotation(double mean_chroma, double mean_hue) {
  const double turn_deg = 30 * std::exp(-std::pow((mean_hue - 275) / 25, 2));
  return -std::sin(radians(2 * turn_deg)) * 2 * chroma_share(mean_chroma);
}

// Equations 8 to 22.
double difference(const LightnessChromaHue& p, const LightnessChromaHue& q) {
  const bool grey = p.C * q.C == 0;
  const double mean_L = (p.L + q.L) / 2, mean_C = (p.C + q.C) / 2;
  const double mean_h = grey ? p.h + q.h : mean_hue_deg(p.h, q.h);
  const double step_h = grey ? 0 : hue_step_deg(p.h, q.h);
  const double dL = q.L - p.L, dC = q.C - p.C;
  const double dH = 2 * std::sqrt(p.C * q.C) * std::sin(radians(step_h / 2));
  const double off_middle = (mean_L - 50) * (mean_L - 50);
  const double L = dL / (1 + 0.015 * off_middle / std::sqrt(20 + off_middle));
  const double C = dC / (1 + 0.045 * mean_C);
  const double H = dH / (1 + 0.015 * mean_C * hue_weight(mean_h));
  return std::sqrt(L * L + C * C + H * H + rotation(mean_C, mean_h) * C * H);
}

Xyz scaled(const Xyz& xyz, double factor) {
  return {xyz[0] * factor, xyz[1] * factor, xyz[2] * factor};
}

}  // namespace

Lab lab_from_xyz(const Xyz& xyz, const Xyz& white) {
  const double x = lab_curve(xyz[0] / white[0]);
  const double y = lab_curve(xyz[1] / white[1]);
  const double z = lab_curve(xyz[2] / white[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double ciede2000(const Lab& a, const Lab& b) {
  const double mean_chroma = (std::hypot(a.a, a.b) + std::hypot(b.a, b.b)) / 2;
  const double g = 0.5 * (1 - chroma_share(mean_chroma));
  return difference(with_stretched_a(a, g), with_stretched_a(b, g));
}

double ciede2000_at_own_luminance(const Xyz& color, const Xyz& reference, const Xyz& white) {
  if (!(reference[1] > 0)) throw std::invalid_argument("CIEDE2000: a reference without luminance");
  const double factor = white[1] / reference[1];
  return ciede2000(lab_from_xyz(scaled(color, factor), white),
                   lab_from_xyz(scaled(reference, factor), white));
}

}  // namespace glare::test
