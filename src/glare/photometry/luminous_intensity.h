// How strong a lamp shines in each direction: its luminous intensity in candela.
#pragma once

#include <array>
#include <vector>

#include "glare/base/image.h"
#include "glare/color/matrix.h"

namespace glare {

/// The spherical coordinates that a goniophotometer measures in (IES LM-63, CIE 121):
enum class PhotometricType {
  a,  ///< H, V about a vertical polar axis: V is the elevation, H the azimuth. Headlamps (ECE,
      ///< SAE).
  b,  ///< H, V about a horizontal polar axis: V turns about it, H is the angle towards it.
  c   ///< C, gamma: gamma from the luminaire's nadir (its axis), C around it from its 0 half-plane.
};

/// How a lamp is mounted: turned from its neutral place first by roll about its axis (clockwise as
/// seen from behind the lamp), then by pitch (up is positive), then by yaw (right is positive, as
/// seen from the vehicle that carries it).
struct Mounting {
  double yaw_deg = 0, pitch_deg = 0, roll_deg = 0;
  /// Of type C: gamma 0 is the vehicle's forward axis, as for headlamps measured so, instead of
  /// down, as for street lights. C 0 is to the right, in both; C 90 forward (gamma 0 down) or up.
  bool gamma_zero_is_forward = false;
};

/// Luminous intensity over direction, linear between measured directions.
class LuminousIntensityDistribution {
 public:
  /// `candela(i, j)` at `horizontal_deg[i]`, `vertical_deg[j]`: H and V for type A and B, C and
  /// gamma for type C. Angles ascend strictly; (symmetries are unfolded before.) Throws
  /// `InputError`.
  LuminousIntensityDistribution(PhotometricType type, std::vector<double> horizontal_deg,
                                std::vector<double> vertical_deg, Image<float> candela);

  PhotometricType type() const;
  const std::vector<double>& horizontal_deg() const;
  const std::vector<double>& vertical_deg() const;
  const Image<float>& candela() const;

  /// The intensity, in candela, in the direction (H, V) in degrees, right and up positive as seen
  /// from the lamp; for type C, (C, gamma). Angles wrap; 0 outside what was measured.
  double operator()(double horizontal_deg, double vertical_deg) const;

  /// The intensity towards a direction (right, up, forward) of the vehicle, of any length but 0.
  double towards(const Vector3& right_up_forward, const Mounting& mounting = {}) const;
};

/// The direction (H, V) of type A, in degrees, of a vector (right, up, forward).
std::array<double, 2> horizontal_vertical_deg(const Vector3& right_up_forward);

/// The vector in the lamp's own axes of a direction in the vehicle's.
Vector3 in_lamp_axes(const Vector3& right_up_forward, const Mounting& mounting);

}  // namespace glare
