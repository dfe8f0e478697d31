// How much a lamp's glare hampers seeing: veiling luminance and threshold increment.
#pragma once

#include <optional>
#include <span>

#include "glare/picture/picture.h"
#include "glare/scatter/straylight.h"
#include "glare/scene/camera.h"
#include "glare/scene/lamp_light.h"
#include "glare/template/glare_template.h"

namespace glare {

/// The angle between two directions of any length but 0, in degrees, 0 to 180.
double angle_between_deg(const Vector3& a, const Vector3& b);

/// The template's veil at `angle_deg` from the lamp, in cd/m^2 per lux at the eye: its mean over
/// the circle at that angle about its axis. Nothing where the circle isn't wholly within the
/// centres of its pixels, or for an angle that isn't 0 to 90.
std::optional<double> template_veil_per_lux(const GlareTemplate& glare_template, double angle_deg);

/// What a point of light does to the sight of something at `angle_deg` from it.
struct GlareSource {
  double illuminance_lux = 0;  ///< At the eye.
  double angle_deg = 0;
};

/// A lamp's light as seen by who looks at something in the direction of `gaze`.
GlareSource glare_source(const LightAtEye& light, const Vector3& gaze = {0, 0, 1});

/// The veiling luminance of all sources together by the CIE general equation (`cie_general_glare`),
/// in cd/m^2: the sum of E * glare(angle). Sources of 0 lux are left out. Nothing where another is
/// beyond the equation's range, 0.1 to 100 degrees. Throws `OptionError` for an age or a pigment
/// out of range.
std::optional<double> cie_veiling_luminance(std::span<const GlareSource> sources,
                                            const Straylight& eye);

/// Threshold increment in percent: by how much more contrast an object must have to be just seen
/// beside the glare, from its veiling luminance L_v and the mean luminance L_av of what the eye is
/// adapted to, both in cd/m^2:
///   65 L_v / L_av^0.8   for 0.05 < L_av <= 5,
///   95 L_v / L_av^1.05  above.
/// Nothing for a lower L_av, for which no figures are agreed on. Sources: CIE 31 (1976) and CIE
/// 140:2000 for both; EN 13201-3 for the first. Throws `OptionError` for a luminance that is
/// negative or not finite.
std::optional<double> threshold_increment_percent(double veiling_luminance,
                                                  double average_luminance);

/// The picture's mean luminance over the solid angle that it covers, in its own unit. Throws
/// `OptionError` for a camera out of range or of another size.
double average_luminance(const Picture& picture, const Camera& camera);

}  // namespace glare
