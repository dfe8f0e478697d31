#include "scene.h"

#include <numbers>

namespace renderer {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kWallHeight_m = 3.4;
using Kind = Material::Kind;

/// A lamp's colour at luminance 1.
Vec3 color_of(const glare::Spectrum& lamp) {
  using glare::operator*;
  const auto& observer = glare::color_matching_functions("cie1931-2deg");
  const glare::Xyz xyz = glare::xyz_from_spectrum(lamp, observer, observer.range());
  const glare::Vector3 rgb = working_space().rgb_from_xyz() * xyz;
  return {rgb[0], rgb[1], rgb[2]};
}

/// A sphere gives pi L for each unit of its surface, 4 pi r^2.
double luminance_of(double flux_lm, double radius_m) {
  return flux_lm / (4 * kPi * kPi * radius_m * radius_m);
}

/// How much of a joint is at a place: joints are every `period`, and 1 is in the midst of one.
double joint(double place, double period, double width) {
  return 1 - vectors::smooth_step(0.5 * width, width, std::abs(std::remainder(place, period)));
}

Material wall_at(Vec3 place) {
  constexpr double kHeight_m = 0.17, kLength_m = 0.46;
  const double row = std::floor(place.y / kHeight_m);
  const double shift = 0.5 * kLength_m * std::fmod(row, 2);
  const double mortar =
      std::max(joint(place.y, kHeight_m, 0.011), joint(place.x + shift, kLength_m, 0.011));
  return {Kind::diffuse, vectors::mix({0.46, 0.40, 0.34}, {0.22, 0.20, 0.18}, mortar)};
}

}  // namespace

glare::RgbColorSpace working_space() {
  return {"lin_rec2020",
          {glare::Chromaticity{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}},
          glare::xyz_from_chromaticity({0.3127, 0.3290})};
}

void Scene::add_bulb(const std::string& lamp, double flux_lm, double radius_m, Vec3 center) {
  const auto spectrum = glare::find_lamp(lamp);
  if (!spectrum) throw glare::OptionError("no lamp is called " + lamp);
  bulbs_.push_back({{center, radius_m}, luminance_of(flux_lm, radius_m) * color_of(*spectrum)});
}

Scene::Scene(double time)
    : balls_{{{{-0.15, 0.75, 4.6}, 0.75}, {Kind::mirror, {0.93, 0.93, 0.92}}},
             {{{-1.75, 0.5, 4.1}, 0.5}, {Kind::glossy, {0.42, 0.035, 0.02}}},
             {{{1.35, 0.55, 4.2}, 0.55}, {Kind::glossy, {0.03, 0.09, 0.36}}},
             {{{0.62, 0.26, 3.1}, 0.26}, {Kind::glass, {1, 1, 1}}},
             {{{-0.95, 0.2, 3.2}, 0.2}, {Kind::diffuse, {0.72, 0.70, 0.66}}},
             {{{2.45, 0.4, 5.2}, 0.4}, {Kind::glossy, {0.42, 0.30, 0.03}}}} {
  // A string of lights along the wall, which hangs between its ends.
  const char* const lamps[] = {"A", "led", "HP1", "D65", "FL12", "HP1", "LED-RGB1", "A"};
  for (int i = 0; i < 8; ++i) {
    const double across = (i - 3.5) / 3.5;
    add_bulb(lamps[i], 26, 0.011, {3.3 * across, 2.02 + 0.42 * across * across, 6.9});
  }
  add_bulb("HP1", 90, 0.012, {-2.55, 0.45, 5.2});
  // Behind the viewer, on the balls' near sides.
  add_bulb("A", 900, 0.03, {-3.2, 2.6, 0.2});
  add_bulb("led", 500, 0.03, {3.4, 2.4, -0.6});
  add_bulb("hid", 900, 0.012, {-2.1 + 3.6 * time, 1.28 - 0.35 * time, 5.75});
}

Material Scene::floor_at(Vec3 place) const {
  constexpr double kTile_m = 0.6;
  const double seam =
      std::max(joint(place.x + 0.3, kTile_m, 0.012), joint(place.z, kTile_m, 0.012));
  const auto tile =
      static_cast<long>(std::floor((place.x + 0.3) / kTile_m) + std::floor(place.z / kTile_m));
  const Vec3 stone = tile % 2 == 0 ? Vec3{0.30, 0.28, 0.25} : Vec3{0.13, 0.12, 0.115};
  return {seam > 0.5 ? Kind::diffuse : Kind::glossy, vectors::mix(stone, {0.05, 0.05, 0.05}, seam)};
}

std::optional<Hit> Scene::first_hit(const Ray& ray) const {
  Hit hit{1e30, {}, {}, {}, nullptr};
  const Ball* ball = nullptr;
  const Plane* plane = nullptr;
  const auto is_nearer = [&](const std::optional<double>& distance) {
    if (!distance || *distance >= hit.distance) return false;
    hit.distance = *distance;
    return true;
  };
  if (is_nearer(floor_.met_by(ray))) plane = &floor_;
  if (const auto at = wall_.met_by(ray); at && ray.at(*at).y < kWallHeight_m && is_nearer(at))
    plane = &wall_;
  for (const Ball& b : balls_)
    if (is_nearer(b.shape.met_by(ray))) ball = &b;
  for (const Bulb& b : bulbs_)
    if (is_nearer(b.shape.met_by(ray))) hit.bulb = &b;
  if (hit.distance > 1e29) return std::nullopt;

  hit.place = ray.at(hit.distance);
  if (hit.bulb) return hit;
  hit.normal = ball ? ball->shape.normal_at(hit.place) : plane->normal;
  hit.material = ball               ? ball->material
                 : plane == &floor_ ? floor_at(hit.place)
                                    : wall_at(hit.place);
  return hit;
}

bool Scene::is_free(const Ray& ray, double distance) const {
  for (const Ball& b : balls_)
    if (const auto at = b.shape.met_by(ray); at && *at < distance) return false;
  return true;
}

Vec3 Scene::sky_luminance(Vec3 direction) const {
  return vectors::mix({0.035, 0.045, 0.075}, {0.006, 0.010, 0.026},
                      vectors::smooth_step(0, 0.6, direction.y));
}

}  // namespace renderer
