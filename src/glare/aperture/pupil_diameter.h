// How wide an adapted eye's pupil is.
#pragma once

namespace glare {

/// What the eye looks at, and whose it is.
struct Adaptation {
  double luminance_cd_m2 = 0.1;  ///< Of the field that the eye is adapted to, 0 to 1e6.
  double field_area_deg2 = 900;  ///< Of that field, above 0 to 41253, the whole sphere.
  double age_years = 28.58;      ///< 20 to 83; that of the observers whom the formula starts from.
  int eyes = 2;                  ///< That see the field: 1 or 2.
};

/// Diameter of the light-adapted pupil, in mm, by the unified formula of Watson and Yellott ("A
/// unified formula for light-adapted pupil size", J. Vision 12(10):12, 2012, eq. 21):
///   D = D_SD + (age - 28.58) (0.02132 - 0.009562 D_SD),
/// with the diameter that Stanley and Davies (Ophthal. Physiol. Opt. 15, 1995) found for the
/// effective corneal flux density F = luminance x area x M(eyes), M(1) = 0.1, M(2) = 1:
///   D_SD = 7.75 - 5.75 (F / 846)^0.41 / ((F / 846)^0.41 + 2).
/// People differ from it: in Winn and others' data by some 0.5 to 1 mm (standard deviation). Throws
/// `OptionError` for a value outside its range.
double pupil_diameter_mm(const Adaptation& adaptation);

}  // namespace glare
