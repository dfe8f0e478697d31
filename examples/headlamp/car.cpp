#include "car.h"

#include <numbers>

namespace headlamp {
namespace {

// Outlines, in metres. Side views are (forward, up), the others are right halves, (right, up) or
// (right, forward), which go on to the left of the middle so that only their outer edges count.
constexpr std::array<Vec2, 17> kBodySide{{{0.74, 0.18},
                                          {0.82, 0.22},
                                          {0.86, 0.32},
                                          {0.88, 0.44},
                                          {0.86, 0.53},
                                          {0.80, 0.57},
                                          {0.79, 0.66},
                                          {0.74, 0.73},
                                          {0.62, 0.79},
                                          {0.30, 0.86},
                                          {-0.10, 0.92},
                                          {-0.45, 0.96},
                                          {-1.6, 0.97},
                                          {-3.05, 1.02},
                                          {-3.34, 0.97},
                                          {-3.42, 0.55},
                                          {-3.34, 0.20}}};
constexpr std::array<Vec2, 10> kBodyFront{{{-2, 0.0},
                                           {0.74, 0.0},
                                           {0.84, 0.24},
                                           {0.885, 0.34},
                                           {0.90, 0.55},
                                           {0.90, 0.66},
                                           {0.875, 0.78},
                                           {0.84, 0.92},
                                           {0.76, 1.06},
                                           {-2, 1.3}}};
constexpr std::array<Vec2, 11> kBodyTop{{{-2, 0.885},
                                         {0.15, 0.88},
                                         {0.35, 0.855},
                                         {0.55, 0.80},
                                         {0.70, 0.71},
                                         {0.80, 0.58},
                                         {0.865, 0.38},
                                         {0.90, 0.05},
                                         {0.905, -2.9},
                                         {0.80, -3.35},
                                         {-2, -3.44}}};
constexpr std::array<Vec2, 8> kCabinSide{{{-0.28, 0.90},
                                          {-0.36, 0.955},
                                          {-1.02, 1.375},
                                          {-1.18, 1.425},
                                          {-1.65, 1.455},
                                          {-2.35, 1.42},
                                          {-3.1, 1.02},
                                          {-3.1, 0.9}}};
constexpr std::array<Vec2, 6> kCabinFront{
    {{-2, 0.6}, {0.82, 0.6}, {0.80, 0.96}, {0.585, 1.42}, {0.50, 1.455}, {-2, 1.6}}};
constexpr std::array<Vec2, 8> kLampOutline{{{0.475, 0.615},
                                            {0.50, 0.695},
                                            {0.66, 0.735},
                                            {0.80, 0.772},
                                            {0.885, 0.785},
                                            {0.885, 0.71},
                                            {0.83, 0.635},
                                            {0.66, 0.595}}};

constexpr double kWheelRadius = 0.325, kRearAxle = -2.58;

double body(Vec3 p) {
  // The bonnet is arched, with a crease on each side.
  const double crown = 0.045 * p.x * p.x + 0.018 * smooth_step(0.50, 0.60, p.x) *
                                               (1 - smooth_step(0.70, 0.80, p.x)) *
                                               smooth_step(0.6, 0.8, p.y);
  const double side = polygon(kBodySide, {p.z, p.y + crown});
  const double front = polygon(kBodyFront, {p.x, p.y});
  const double top = polygon(kBodyTop, {p.x, p.z});
  return rounded_intersection(rounded_intersection(side, front, 0.10), top, 0.08);
}

double cabin(Vec3 p) {
  const double bow = 0.16 * p.x * p.x;
  const double side = polygon(kCabinSide, {p.z + bow, p.y + 0.06 * p.x * p.x});
  return rounded_intersection(side, polygon(kCabinFront, {p.x, p.y}), 0.07);
}

double grille_outline(Vec2 p) {
  return rounded_rectangle({p.x, p.y - 0.645 - 0.03 * p.x * p.x},
                           {0.425 - 0.25 * (0.69 - p.y), 0.045}, 0.03);
}

double intake_outline(Vec2 p) {
  return rounded_rectangle({p.x, p.y - 0.315}, {0.50 - 0.4 * (p.y - 0.315), 0.07}, 0.04);
}

double fog_outline(Vec2 p) {
  return rounded_rectangle({p.x - 0.69, p.y - 0.335 - 0.2 * (p.x - 0.69)}, {0.085, 0.055}, 0.04);
}

/// A hollow of a depth in the front, of an outline seen from ahead.
double hollowed(double solid, double outline, double depth, double z) {
  return std::max(solid, -std::max({outline, -(solid + depth), 0.2 - z}));
}

double wheel_place(double z) { return std::abs(z - 0.5 * kRearAxle) + 0.5 * kRearAxle; }

/// In the axes of the wheel nearest, x from the middle of its width.
Vec3 in_wheel(Vec3 p) { return {p.x - 0.765, p.y - kWheelRadius, wheel_place(p.z)}; }

double shell(Vec3 p) {
  double d = body(p);
  d = hollowed(d, grille_outline({p.x, p.y}), 0.05, p.z);
  d = hollowed(d, intake_outline({p.x, p.y}), 0.06, p.z);
  d = hollowed(d, fog_outline({p.x, p.y}), 0.04, p.z);
  d = filleted_union(d, cabin(p), 0.015);
  const Vec3 wheel = in_wheel(p);
  const double arch = std::max(std::hypot(wheel.y, wheel.z) - 0.375, 0.5 - p.x);
  return rounded_intersection(d, -arch, 0.03);
}

double slats(Vec3 p, double front) {
  const double bar = std::abs(std::remainder(p.y - 0.645, 0.030)) - 0.006;
  return std::max({grille_outline({p.x, p.y}), bar, front + 0.02, -(front + 0.05)});
}

double badge(Vec3 p) { return std::hypot(p.x, 1.15 * (p.y - 0.645)) - 0.048; }

double wheels(Vec3 p) {
  const Vec3 w = in_wheel(p);
  return disc(w, kWheelRadius, 0.10, 0.045);
}

double mirrors(Vec3 p) {
  const Vec3 q{p.x - 0.985, p.y - 1.02, p.z + 0.66 - 0.15 * (p.x - 0.985)};
  const double arm = rounded_box(p - Vec3{0.86, 0.965, -0.66}, {0.08, 0.018, 0.04}, 0.015);
  return filleted_union(rounded_box(q, {0.115, 0.072, 0.075}, 0.06), arm, 0.03);
}

double plate(Vec3 p) { return rounded_box(p - Vec3{0, 0.475, 0.885}, {0.26, 0.056, 0.012}, 0.006); }

Vec3 right_half(Vec3 p) { return {std::abs(p.x), p.y, p.z}; }

struct Candidate {
  double distance;
  Part part;
};

Part shell_part(Vec3 p, Vec3 normal) {
  const Vec2 front{p.x, p.y};
  if (p.z > 0.2 && std::min({grille_outline(front), intake_outline(front)}) < 0.004)
    return badge(p) < 0 ? Part::chrome : Part::grille;
  if (p.z > 0.2 && fog_outline(front) < 0.004) return Part::plastic;
  if (p.z > 0.2 && p.y > 0.5 && polygon(kLampOutline, front) < 0) return Part::lamp;
  if (p.y < 0.235 || (std::hypot(in_wheel(p).y, in_wheel(p).z) < 0.372 && p.x > 0.5))
    return Part::plastic;
  if (cabin(p) > 0.004 || p.y < 0.97) return Part::paint;
  const double half_width = -polygon(kCabinFront, {p.x, p.y});
  if (normal.z > 0.35) return half_width > 0.055 && p.y < 1.385 ? Part::windscreen : Part::paint;
  const bool pillar = std::abs(p.z + 1.75) < 0.05 || p.z < -2.75;
  const double roof_edge = -polygon(kCabinSide, {p.z + 0.16 * p.x * p.x, p.y});
  if (normal.x > 0.6 && roof_edge > 0.06 && p.y > 0.99 && !pillar) return Part::side_window;
  return Part::paint;
}

}  // namespace

double car_distance(Vec3 place) {
  const Vec3 p = right_half(place);
  double d = shell(p);
  if (p.z > 0.4) {
    if (p.y > 0.55 && p.y < 0.75) d = std::min(d, slats(p, body(p)));
    d = std::min(d, plate(p));
  }
  return 0.9 * std::min({d, wheels(p), mirrors(p)});
}

Part car_part(Vec3 place, Vec3 normal) {
  const Vec3 p = right_half(place);
  const Candidate nearest = std::min(
      {Candidate{shell(p), Part::paint}, Candidate{p.z > 0.4 ? slats(p, body(p)) : 1, Part::chrome},
       Candidate{plate(p), Part::plate}, Candidate{wheels(p), Part::tyre},
       Candidate{mirrors(p), Part::chrome}},
      [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  if (nearest.distance == mirrors(p)) return p.y < 0.985 ? Part::plastic : Part::paint;
  if (nearest.part == Part::tyre) {
    const Vec3 w = in_wheel(p);
    return std::hypot(w.y, w.z) < 0.215 && w.x > 0.05 ? Part::rim : Part::tyre;
  }
  if (nearest.part != Part::paint) return nearest.part;
  return shell_part(p, {std::abs(normal.x), normal.y, normal.z});
}

bool on_spoke(Vec3 p) {
  const Vec3 wheel = in_wheel(right_half(p));
  const double radius = std::hypot(wheel.y, wheel.z);
  const double angle = std::remainder(std::atan2(wheel.y, wheel.z), 0.4 * std::numbers::pi);
  return radius < 0.05 || radius > 0.195 || std::abs(angle) * radius < 0.02 + 0.08 * radius;
}

Vec3 car_normal(Vec3 p) {
  constexpr double kStep = 4e-4;
  Vec3 sum;  // Over a tetrahedron's corners, distances times their directions are the slope.
  for (const Vec3 corner : {Vec3{1, -1, -1}, Vec3{-1, -1, 1}, Vec3{-1, 1, -1}, Vec3{1, 1, 1}})
    sum = sum + car_distance(p + kStep * corner) * corner;
  return normalized(sum);
}

Vec3 place_on_front(Vec2 right_up) {
  double z = kCarHigh.z;
  for (int i = 0; i < 100; ++i) z -= car_distance({right_up.x, right_up.y, z});
  return {right_up.x, right_up.y, z};
}

}  // namespace headlamp
