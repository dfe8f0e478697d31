// Straylight: what an eye's media scatter, beside what its aperture diffracts.
#pragma once

namespace glare {

/// The limits of `Straylight`. Up to 100 years, for every pigment, the equation below has room in
/// the light that there is; at 105 it would scatter more than all of it.
inline constexpr double kOldestStraylight_years = 100;
inline constexpr double kPalestStraylight = 1.2;

/// The eye that scatters.
struct Straylight {
  /// Years, 0 to 100.
  double age_years = 35;

  /// Of the iris and the eye's wall, 0 to 1.2: 0 for very dark (non-caucasian) eyes, 0.5 brown,
  /// 1 blue-green, 1.2 light blue.
  double pigment = 0.5;

  bool operator==(const Straylight&) const = default;
};

/// The smallest angle of the CIE equation, and where `straylight_per_steradian` leaves it.
inline constexpr double kSmallestCieAngle_deg = 0.1;
inline constexpr double kLargestCieAngle_deg = 100;

/// Throws `OptionError` for an age or a pigment outside its range, or one that isn't a number.
void require_valid(const Straylight& eye);

/// The CIE general disability glare equation: the veiling luminance that a point source at
/// `angle_deg` makes, per lux at the eye, in (cd/m^2)/lx = 1/sr. With theta in degrees,
///   10 / theta^3 + (5 / theta^2 + 0.1 p / theta) (1 + (age / 62.5)^4) + 0.0025 p,
/// for 0.1 to 100 degrees. It tells all that an eye spreads, diffraction among it. Sources: CIE
/// 146:2002; Vos and van den Berg in CIE 135/1 (1999); Vos, Clin. Exp. Optom. 86 (2003) 363.
///
/// The function itself is the formula for any angle above 0. Throws `OptionError` for another
/// angle, and for an age or pigment outside the range of `Straylight`.
double cie_general_glare(double angle_deg, double age_years, double pigment);

/// The straylight S of a template, per steradian, for angles of 0 to 90 degrees: the general
/// equation at the softened angle (theta^12 + 0.075^12)^(1/12) degrees. From 0.1 degrees on it is
/// below the equation by less than 0.8 %, and beyond 0.13 degrees by less than 0.04 %. Nearer the
/// axis it bends into a plateau: finite, and smoothly decreasing everywhere. docs/scatter.md says
/// why it is this shape. Throws as `cie_general_glare`, but takes 0.
double straylight_per_steradian(const Straylight& eye, double angle_deg);

/// The share of all light that is scattered further than `beyond_deg` from the axis: the integral
/// of S over the directions up to 90 degrees, by direction sine, 2 pi S(theta) sin(theta)
/// cos(theta) dtheta. From 0 it is the share s that a template takes from the diffracted light,
/// 0.44 for the youngest eye to 0.98 for the oldest and palest. Throws as
/// `straylight_per_steradian`.
double scattered_energy(const Straylight& eye, double beyond_deg = 0);

}  // namespace glare
