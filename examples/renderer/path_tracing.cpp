#include "path_tracing.h"

#include <numbers>

namespace renderer {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kMostBounces = 7;
/// So early in a path both what a surface mirrors and what it passes on are followed.
constexpr int kBothFollowed = 2;

/// Unpolarised light mirrored by a smooth surface, of an index relative to where it comes from;
/// R. L. Cook and K. E. Torrance, ACM Transactions on Graphics 1(1), 1982, 7-24.
double fresnel_reflectance(double cosine, double index) {
  const double squared = index * index - 1 + cosine * cosine;
  if (squared <= 0) return 1;
  const double g = std::sqrt(squared), plus = g + cosine, minus = g - cosine;
  const double ratio = (cosine * plus - 1) / (cosine * minus + 1);
  return 0.5 * (minus * minus) / (plus * plus) * (1 + ratio * ratio);
}

/// The direction at angles from an axis.
Vec3 about(Vec3 axis, double cosine, double azimuth) {
  const Vec3 across = std::abs(axis.x) > 0.6 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  const Vec3 u = normalized(cross(axis, across)), v = cross(axis, u);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return cosine * axis + sine * (std::cos(azimuth) * u + std::sin(azimuth) * v);
}

class Path {
 public:
  Path(const Scene& scene, Random& random) : scene_(scene), random_(random) {}

  /// After a diffuse bounce bulbs aren't counted where a ray meets them: they were, straight.
  Vec3 luminance(const Ray& ray, int bounces, bool sees_bulbs) {
    if (bounces > kMostBounces) return {};
    const auto hit = scene_.first_hit(ray);
    if (!hit) return scene_.sky_luminance(ray.direction);
    if (hit->bulb) return sees_bulbs ? hit->bulb->luminance : Vec3{};
    switch (hit->material.kind) {
      case Material::Kind::mirror:
        return in_mirror(ray, *hit, bounces, sees_bulbs);
      case Material::Kind::glass:
        return through_glass(ray, *hit, bounces, sees_bulbs);
      case Material::Kind::glossy:
        return on_glossy(ray, *hit, bounces, sees_bulbs);
      case Material::Kind::diffuse:
        break;
    }
    return diffuse(*hit, bounces);
  }

 private:
  Vec3 mirrored_light(const Ray& ray, const Hit& hit, int bounces, bool sees_bulbs) {
    const Ray on{hit.place, normalized(mirrored(ray.direction, hit.normal))};
    return luminance(on, bounces + 1, sees_bulbs);
  }

  /// Of metal: Schlick's approximation of its reflectance.
  Vec3 in_mirror(const Ray& ray, const Hit& hit, int bounces, bool sees_bulbs) {
    const double grazing = std::pow(1 - std::abs(dot(ray.direction, hit.normal)), 5);
    return vectors::mix(hit.material.reflectance, {1, 1, 1}, grazing) *
           mirrored_light(ray, hit, bounces, sees_bulbs);
  }

  /// Both parts, by their shares; later in a path one of them, picked with their chances.
  template <typename Mirrored, typename Passed>
  Vec3 shared(double reflectance, int bounces, const Mirrored& mirrored, const Passed& passed) {
    if (bounces >= kBothFollowed) return random_.next() < reflectance ? mirrored() : passed();
    return reflectance * mirrored() + (1 - reflectance) * passed();
  }

  Vec3 through_glass(const Ray& ray, const Hit& hit, int bounces, bool sees_bulbs) {
    const bool enters = dot(ray.direction, hit.normal) < 0;
    const Vec3 normal = enters ? hit.normal : -1.0 * hit.normal;
    const double index = enters ? hit.material.refractive_index : 1 / hit.material.refractive_index;
    const double cosine = -dot(ray.direction, normal);
    const auto passed = [&] {
      const double inside = std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (index * index)));
      const Vec3 bent = (1 / index) * ray.direction + (cosine / index - inside) * normal;
      return luminance({hit.place, normalized(bent)}, bounces + 1, sees_bulbs);
    };
    return shared(
        fresnel_reflectance(cosine, index), bounces,
        [&] { return mirrored_light(ray, hit, bounces, sees_bulbs); }, passed);
  }

  Vec3 on_glossy(const Ray& ray, const Hit& hit, int bounces, bool sees_bulbs) {
    const double cosine = std::min(1.0, std::abs(dot(ray.direction, hit.normal)));
    return shared(
        fresnel_reflectance(cosine, hit.material.refractive_index), bounces,
        [&] { return mirrored_light(ray, hit, bounces, sees_bulbs); },
        [&] { return diffuse(hit, bounces); });
  }

  /// Lambert's: as bright from everywhere.
  Vec3 diffuse(const Hit& hit, int bounces) {
    Vec3 illuminance = straight_illuminance(hit);
    const double cosine = std::sqrt(random_.next());  // chances as the cosine to the normal
    const Ray on{hit.place, about(hit.normal, cosine, 2 * kPi * random_.next())};
    illuminance = illuminance + kPi * luminance(on, bounces + 1, false);
    return (1 / kPi) * (hit.material.reflectance * illuminance);
  }

  /// From the bulbs, lux: of each, one direction within the cone that it fills.
  Vec3 straight_illuminance(const Hit& hit) {
    Vec3 sum;
    for (const Bulb& bulb : scene_.bulbs()) {
      const Vec3 to_center = bulb.shape.center - hit.place;
      const double distance = length(to_center), sine = bulb.shape.radius / distance;
      if (sine >= 1 || dot(to_center, hit.normal) < -bulb.shape.radius) continue;
      const double missing = sine * sine / (1 + std::sqrt(1 - sine * sine));  // 1 - cosine
      const Vec3 direction =
          about((1 / distance) * to_center, 1 - missing * random_.next(), 2 * kPi * random_.next());
      const double cosine = dot(direction, hit.normal);
      if (cosine <= 0 || !scene_.is_free({hit.place, direction}, distance)) continue;
      sum = sum + (2 * kPi * missing * cosine) * bulb.luminance;
    }
    return sum;
  }

  const Scene& scene_;
  Random& random_;
};

}  // namespace

double Random::next() {
  const std::uint64_t old = state_;
  state_ = old * 6364136223846793005u + 1442695040888963407u;
  const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
  const auto turn = static_cast<unsigned>(old >> 59);
  return ((mixed >> turn) | (mixed << (-turn & 31))) * 0x1p-32;
}

Vec3 traced_luminance(const Scene& scene, const Ray& ray, Random& random) {
  return Path(scene, random).luminance(ray, 0, true);
}

}  // namespace renderer
