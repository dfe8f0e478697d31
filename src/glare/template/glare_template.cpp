#include "glare/template/glare_template.h"

#include "glare/base/error.h"
#include "glare/base/units.h"

namespace glare {

std::string to_string(Normalization normalization) {
  switch (normalization) {
    case Normalization::energy:
      return "energy";
    case Normalization::absolute:
      return "absolute";
    default:
      return "peak";
  }
}

Normalization normalization_from(const std::string& name) {
  for (const auto n : {Normalization::peak, Normalization::energy, Normalization::absolute})
    if (to_string(n) == name) return n;
  throw OptionError("unknown normalization '" + name + "'; expected peak, energy or absolute");
}

double GlareTemplate::pixel_pitch_deg() const { return pixel_pitch_rad / kRadPerDeg; }

double GlareTemplate::luminance(int x, int y) const {
  const Vector3& weights = color_space.xyz_from_rgb()[1];
  return weights[0] * channels[0](x, y) + weights[1] * channels[1](x, y) +
         weights[2] * channels[2](x, y);
}

void rescale(GlareTemplate& glare_template, double per_steradian) {
  const double factor = glare_template.per_steradian / per_steradian;
  for (auto& channel : glare_template.channels)
    for (float& value : channel.values()) value = static_cast<float>(value * factor);
  glare_template.per_steradian = per_steradian;
}

}  // namespace glare
