#include "glare/aperture/eye/eyelids.h"

namespace glare {

Eyelids::Eyelids(const EyelidParameters& p, double closure)
    : above_(p.share_above * p.opening_mm), below_((1 - p.share_above) * p.opening_mm) {
  constexpr double overlap_mm = 0.3;
  above_ -= closure * (p.opening_mm + overlap_mm);
}

std::vector<Outline> Eyelids::outlines(double reach_mm) const {
  constexpr int pieces = 1024;  // Their sagittas are at most 0.02 um.
  const double beyond_mm = 1.01 * reach_mm;
  std::vector<Outline> result;
  const auto add = [&](auto margin, double outer_y) {
    std::vector<Point> vertices{{beyond_mm, outer_y}, {-beyond_mm, outer_y}};
    for (int i = 0; i <= pieces; ++i) {
      const double x = beyond_mm * (2.0 * i / pieces - 1);
      // A margin beyond the far side of the picture covers all of it.
      vertices.push_back({x, std::clamp(margin(x), -beyond_mm, beyond_mm)});
    }
    const Outline lid(vertices);
    if (lid.area_mm2() > 0) result.push_back(lid);
  };
  add([this](double x) { return upper(x); }, -beyond_mm);
  add([this](double x) { return lower(x); }, beyond_mm);
  return result;
}

}  // namespace glare
