// How strong a lamp shines in each direction: its luminous intensity in candela.
#pragma once

#include <array>
#include <vector>

#include "glare/base/image.h"
#include "glare/color/matrix.h"

namespace glare {

/// The spherical coordinates that a goniophotometer measures in (ANSI/IES LM-63, CIE 121), in the
/// lamp's own axes (right, up, forward), forward being where it shines and right as seen from
/// behind it:
enum class PhotometricType {
  /// H, V about the vertical axis: V = asin(up), the elevation, and H = atan2(right, forward), the
  /// azimuth. Headlamps (UN ECE, SAE).
  a,
  /// H, V about the horizontal axis to the right: V = atan2(up, forward) turns about it, and
  /// H = asin(right) is the angle towards it. Floodlights, whose aim is forward here (LM-63 draws
  /// it
  /// at the nadir).
  b,
  /// C, gamma: gamma = 0 to 180 from the luminaire's axis; C = 0 to 360 about it. Neutrally the
  /// axis is down: C 0 is to the right and C 90 forward, so that C increases counterclockwise as
  /// seen from above. Street lights have the street at C 90 in EULUMDAT (CIE), so neutrally ahead;
  /// makers of LM-63 files have it at C 0: a yaw of -90 degrees brings it ahead.
  c
};

/// How a lamp is mounted: turned from its neutral place first by roll about its forward axis
/// (clockwise as seen from behind the lamp), then by pitch (up is positive), then by yaw (right is
/// positive, as seen from the vehicle that carries it); pitch and yaw about the vehicle's axes.
struct Mounting {
  double yaw_deg = 0, pitch_deg = 0, roll_deg = 0;
  /// Of type C: gamma 0 is the lamp's forward axis, as for headlamps and spotlights measured so,
  /// instead of down. C 0 is to the right in both; C 90 is then up instead of forward: the
  /// luminaire is tilted up by 90 degrees.
  bool gamma_zero_is_forward = false;
};

/// Luminous intensity over direction: measured on a grid of two angles, linear in each of them
/// between the measured ones (bilinear), 0 outside.
class LuminousIntensityDistribution {
 public:
  /// `candela(i, j)` at `horizontal_deg[i]`, `vertical_deg[j]`: H and V for type A and B, C and
  /// gamma for type C. At least two of each, finite, strictly ascending; symmetries are unfolded.
  /// The angle about the polar axis (H of type A, V of B, C) spans 360 degrees at most, from
  /// anywhere within -360 to 720; where it spans 360 the circle is closed. The angle towards the
  /// axis (V of type A, H of B) is within -90 to 90, gamma within 0 to 180. Intensities are finite
  /// and not negative: what a photometer's noise makes negative, whoever measured it has to judge.
  /// Throws `InputError`, without a place.
  LuminousIntensityDistribution(PhotometricType type, std::vector<double> horizontal_deg,
                                std::vector<double> vertical_deg, Image<float> candela);

  PhotometricType type() const { return type_; }
  const std::vector<double>& horizontal_deg() const { return horizontal_.angles_deg; }
  const std::vector<double>& vertical_deg() const { return vertical_.angles_deg; }
  const Image<float>& candela() const { return candela_; }

  /// The intensity, in candela, in the direction (H, V) in degrees, right and up positive as seen
  /// from behind the lamp; for type C, (C, gamma). Any angles are good: they wrap, also across the
  /// poles. 0 outside what was measured, by more than a rounding error (1e-6 degrees). At a pole
  /// the value is that of the given azimuth.
  double operator()(double horizontal_deg, double vertical_deg) const;

  /// The intensity, in candela, towards a direction (right, up, forward) of the vehicle, of any
  /// length but 0. At a pole the azimuth is 0.
  double towards(const Vector3& right_up_forward, const Mounting& mounting = {}) const;

 private:
  struct Axis {
    std::vector<double> angles_deg;
    double steps_per_deg = 0;  ///< Of equal steps; else 0.
  };
  struct Place {
    int index = -1;     ///< Between this angle and the next one; -1: outside.
    double weight = 0;  ///< Of the next one.
  };
  static Axis axis_of(std::vector<double> angles_deg);
  static Place place_of(const Axis& axis, double angle_deg);

  PhotometricType type_;
  Axis horizontal_, vertical_;
  Image<float> candela_;
};

/// The direction (H, V) of type A, in degrees, of a vector (right, up, forward) of any length but
/// 0: H = atan2(right, forward) and V = asin(up / length).
std::array<double, 2> horizontal_vertical_deg(const Vector3& right_up_forward);

/// The direction in the coordinates of a type: (H, V), or (C, gamma) with C in 0 to 360, gamma 0
/// down or, where told, forward.
std::array<double, 2> photometric_angles_deg(PhotometricType type, const Vector3& right_up_forward,
                                             bool gamma_zero_is_forward = false);

/// The unit vector (right, up, forward) of a direction in the coordinates of a type; the inverse of
/// `photometric_angles_deg`.
Vector3 direction_from_angles(PhotometricType type, double horizontal_deg, double vertical_deg,
                              bool gamma_zero_is_forward = false);

/// The vector in the lamp's own axes of a direction in the vehicle's: roll^-1 pitch^-1 yaw^-1 of
/// it; its length is kept.
Vector3 in_lamp_axes(const Vector3& right_up_forward, const Mounting& mounting);

}  // namespace glare
