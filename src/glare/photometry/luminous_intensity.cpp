#include "glare/photometry/luminous_intensity.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "glare/base/error.h"
#include "glare/base/units.h"

namespace glare {

namespace {

constexpr double kRounding_deg = 1e-6;

double in_deg(double angle_rad) { return angle_rad / kRadPerDeg; }

struct CosineSine {
  double cosine, sine;
};

/// Exact for the multiples of 90 degrees.
CosineSine cosine_sine(double angle_deg) {
  const double reduced_deg = std::remainder(angle_deg, 360);
  if (std::fmod(reduced_deg, 90) == 0) {
    switch (static_cast<int>(reduced_deg / 90)) {
      case 0:
        return {1, 0};
      case 1:
        return {0, 1};
      case -1:
        return {0, -1};
      default:
        return {-1, 0};
    }
  }
  return {std::cos(reduced_deg * kRadPerDeg), std::sin(reduced_deg * kRadPerDeg)};
}

std::string number_text(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

void require_ascending(const std::vector<double>& angles_deg, const std::string& name) {
  if (angles_deg.size() < 2) throw InputError("", "there are fewer than two " + name + " angles");
  for (std::size_t i = 0; i < angles_deg.size(); ++i) {
    if (!std::isfinite(angles_deg[i])) throw InputError("", "a " + name + " angle isn't finite");
    if (i > 0 && angles_deg[i] <= angles_deg[i - 1])
      throw InputError("", "the " + name + " angles don't ascend: " + number_text(angles_deg[i]) +
                               " follows " + number_text(angles_deg[i - 1]));
  }
}

void require_within(const std::vector<double>& angles_deg, double low, double high,
                    const std::string& name) {
  if (angles_deg.front() < low || angles_deg.back() > high)
    throw InputError("", "the " + name + " angles go from " + number_text(angles_deg.front()) +
                             " to " + number_text(angles_deg.back()) + "; expected within " +
                             number_text(low) + " to " + number_text(high));
}

void require_one_turn(const std::vector<double>& angles_deg, const std::string& name) {
  require_within(angles_deg, -360, 720, name);
  if (angles_deg.back() - angles_deg.front() > 360 + kRounding_deg)
    throw InputError("", "the " + name + " angles span more than 360 degrees");
}

void require_intensities(const Image<float>& candela, std::size_t width, std::size_t height) {
  if (candela.width() != static_cast<int>(width) || candela.height() != static_cast<int>(height))
    throw InputError("", "the intensities are " + std::to_string(candela.width()) + " x " +
                             std::to_string(candela.height()) + ", the angles " +
                             std::to_string(width) + " x " + std::to_string(height));
  for (const float value : candela.values())
    if (!std::isfinite(value) || value < 0)
      throw InputError("", "an intensity is negative or not finite");
}

/// The angles with the one towards the polar axis in its range: across a pole the azimuth turns by
/// 180 degrees. `middle` is that angle's middle, 0 or 90 degrees.
void bring_within_poles(double& azimuth_deg, double& polar_deg, double middle_deg) {
  double elevation_deg = polar_deg - middle_deg;
  if (std::abs(elevation_deg) <= 90) return;
  elevation_deg = std::remainder(elevation_deg, 360);
  if (std::abs(elevation_deg) > 90) {
    elevation_deg = std::copysign(180, elevation_deg) - elevation_deg;
    azimuth_deg += 180;
  }
  polar_deg = elevation_deg + middle_deg;
}

/// The same azimuth within the turn that begins at the first measured angle.
double in_measured_turn(double azimuth_deg, double first_deg, double last_deg) {
  if (azimuth_deg >= first_deg && azimuth_deg <= last_deg) return azimuth_deg;
  double past_first_deg = std::fmod(azimuth_deg - first_deg, 360);
  if (past_first_deg < 0) past_first_deg += 360;
  if (past_first_deg > 360 - kRounding_deg && first_deg + past_first_deg > last_deg)
    past_first_deg -= 360;
  return first_deg + past_first_deg;
}

}  // namespace

LuminousIntensityDistribution::Axis LuminousIntensityDistribution::axis_of(
    std::vector<double> angles_deg) {
  const double span_deg = angles_deg.back() - angles_deg.front();
  const double step_deg = span_deg / static_cast<double>(angles_deg.size() - 1);
  bool equal_steps = true;
  for (std::size_t i = 0; i < angles_deg.size(); ++i) {
    const double expected_deg = angles_deg.front() + static_cast<double>(i) * step_deg;
    equal_steps = equal_steps && std::abs(angles_deg[i] - expected_deg) <= 1e-9 * step_deg;
  }
  return {std::move(angles_deg), equal_steps ? 1 / step_deg : 0};
}

LuminousIntensityDistribution::Place LuminousIntensityDistribution::place_of(const Axis& axis,
                                                                             double angle_deg) {
  const std::vector<double>& angles_deg = axis.angles_deg;
  const double first_deg = angles_deg.front(), last_deg = angles_deg.back();
  if (!(angle_deg >= first_deg - kRounding_deg && angle_deg <= last_deg + kRounding_deg)) return {};
  angle_deg = std::clamp(angle_deg, first_deg, last_deg);
  const int last_index = static_cast<int>(angles_deg.size()) - 2;
  if (axis.steps_per_deg > 0) {
    const double steps = (angle_deg - first_deg) * axis.steps_per_deg;
    const int index = std::min(static_cast<int>(steps), last_index);
    return {index, steps - index};
  }
  const auto next = std::upper_bound(angles_deg.begin() + 1, angles_deg.end() - 1, angle_deg);
  const auto index = next - angles_deg.begin() - 1;
  return {static_cast<int>(index), (angle_deg - *(next - 1)) / (*next - *(next - 1))};
}

LuminousIntensityDistribution::LuminousIntensityDistribution(PhotometricType type,
                                                             std::vector<double> horizontal_deg,
                                                             std::vector<double> vertical_deg,
                                                             Image<float> candela)
    : type_(type) {
  require_ascending(horizontal_deg, "horizontal");
  require_ascending(vertical_deg, "vertical");
  const bool b = type == PhotometricType::b, c = type == PhotometricType::c;
  require_one_turn(b ? vertical_deg : horizontal_deg, b ? "vertical" : "horizontal");
  require_within(b ? horizontal_deg : vertical_deg, c ? 0 : -90, c ? 180 : 90,
                 b ? "horizontal" : "vertical");
  require_intensities(candela, horizontal_deg.size(), vertical_deg.size());
  horizontal_ = axis_of(std::move(horizontal_deg));
  vertical_ = axis_of(std::move(vertical_deg));
  candela_ = std::move(candela);
}

double LuminousIntensityDistribution::operator()(double horizontal_deg, double vertical_deg) const {
  const bool b = type_ == PhotometricType::b;
  double& azimuth_deg = b ? vertical_deg : horizontal_deg;
  double& polar_deg = b ? horizontal_deg : vertical_deg;
  bring_within_poles(azimuth_deg, polar_deg, type_ == PhotometricType::c ? 90 : 0);
  const std::vector<double>& turn_deg = (b ? vertical_ : horizontal_).angles_deg;
  azimuth_deg = in_measured_turn(azimuth_deg, turn_deg.front(), turn_deg.back());
  const Place column = place_of(horizontal_, horizontal_deg);
  const Place row = place_of(vertical_, vertical_deg);
  if (column.index < 0 || row.index < 0) return 0;
  const auto along_row = [&](int y) {
    const double left = candela_(column.index, y), right = candela_(column.index + 1, y);
    return left + column.weight * (right - left);
  };
  const double first = along_row(row.index), second = along_row(row.index + 1);
  return first + row.weight * (second - first);
}

double LuminousIntensityDistribution::towards(const Vector3& right_up_forward,
                                              const Mounting& mounting) const {
  const auto [horizontal_deg, vertical_deg] = photometric_angles_deg(
      type_, in_lamp_axes(right_up_forward, mounting), mounting.gamma_zero_is_forward);
  return (*this)(horizontal_deg, vertical_deg);
}

std::array<double, 2> horizontal_vertical_deg(const Vector3& right_up_forward) {
  const auto [right, up, forward] = right_up_forward;
  assert(right != 0 || up != 0 || forward != 0);
  return {in_deg(std::atan2(right, forward)), in_deg(std::atan2(up, std::hypot(right, forward)))};
}

std::array<double, 2> photometric_angles_deg(PhotometricType type, const Vector3& right_up_forward,
                                             bool gamma_zero_is_forward) {
  const auto [right, up, forward] = right_up_forward;
  if (type == PhotometricType::a) return horizontal_vertical_deg(right_up_forward);
  if (type == PhotometricType::b)
    return {in_deg(std::atan2(right, std::hypot(up, forward))), in_deg(std::atan2(up, forward))};
  const double along = gamma_zero_is_forward ? forward : -up;
  const double c90 = gamma_zero_is_forward ? up : forward;
  const double c_deg = in_deg(std::atan2(c90, right));
  return {c_deg < 0 ? c_deg + 360 : c_deg, in_deg(std::atan2(std::hypot(right, c90), along))};
}

Vector3 direction_from_angles(PhotometricType type, double horizontal_deg, double vertical_deg,
                              bool gamma_zero_is_forward) {
  const auto [cos_h, sin_h] = cosine_sine(horizontal_deg);
  const auto [cos_v, sin_v] = cosine_sine(vertical_deg);
  if (type == PhotometricType::a) return {cos_v * sin_h, sin_v, cos_v * cos_h};
  if (type == PhotometricType::b) return {sin_h, cos_h * sin_v, cos_h * cos_v};
  const double right = sin_v * cos_h, c90 = sin_v * sin_h;
  if (gamma_zero_is_forward) return {right, c90, cos_v};
  return {right, -cos_v, c90};
}

Vector3 in_lamp_axes(const Vector3& right_up_forward, const Mounting& mounting) {
  auto [right, up, forward] = right_up_forward;
  // From one axis towards another by an angle, undone.
  const auto turn_back = [](double& from, double& to, double angle_deg) {
    const auto [cosine, sine] = cosine_sine(angle_deg);
    const double turned = cosine * from + sine * to;
    to = cosine * to - sine * from;
    from = turned;
  };
  turn_back(forward, right, mounting.yaw_deg);
  turn_back(forward, up, mounting.pitch_deg);
  turn_back(up, right, mounting.roll_deg);
  return {right, up, forward};
}

}  // namespace glare
