// A car's front on a street at dusk, in cd/m^2 of linear BT.709, without its lamps' light.
//   render_car CAR.exr [--yaw-deg A] [--distance-m D] [--fov-deg F] [--eye-height-m H]
//              [--size WxH] [--samples N] [--outline OUTLINE.exr] [--threads N]
// Prints, as TOML, where the car and its lamps are, as a scene of glare headlamp takes them. The
// outline is 1 where the car is, 0 elsewhere.
#include <glare/glare.h>
#include <glare/glare_io.h>

#include <atomic>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "car.h"
#include "scene.h"

namespace {

using headlamp::Vec3;

struct Options {
  double yaw_deg = 0;      ///< To the car's own right.
  double distance_m = 25;  ///< To the middle of the front axle.
  double fov_deg = 9;      ///< From left to right.
  double eye_height_m = 1.2;
  int width = 640, height = 480;
  int samples = 3;  ///< Across a pixel, and down it.
  int threads = 0;
  std::string output, outline;
};

struct Rendering {
  explicit Rendering(const Options& o) : outline(o.width, o.height) {
    for (auto& channel : picture.channels) channel = glare::Image<float>(o.width, o.height);
  }
  glare::Picture picture;
  glare::Image<float> outline;  ///< The share of each pixel that is the car.
};

Vec3 direction_of(const Options& o, double column, double row) {
  const double focal_length_px = 0.5 * o.width / std::tan(o.fov_deg * std::numbers::pi / 360);
  return headlamp::normalized(
      {(column - 0.5 * o.width) / focal_length_px, (0.5 * o.height - row) / focal_length_px, 1});
}

void render_pixel(const headlamp::Scene& scene, const Options& o, int x, int y, Rendering& to) {
  const Vec3 eye{0, o.eye_height_m, 0};
  const double weight = 1.0 / (o.samples * o.samples);
  Vec3 sum;
  double car = 0;
  for (int i = 0; i < o.samples * o.samples; ++i) {
    const Vec3 direction = direction_of(o, x + (i % o.samples + 0.5) / o.samples,
                                        y + (i / o.samples + 0.5) / o.samples);
    const auto hit = scene.on_car(eye, direction);
    car += hit ? weight : 0;
    sum = sum + weight * (hit ? scene.car_luminance(*hit, direction)
                              : scene.street_luminance(eye, direction));
  }
  to.picture.channels[0](x, y) = static_cast<float>(sum.x);
  to.picture.channels[1](x, y) = static_cast<float>(sum.y);
  to.picture.channels[2](x, y) = static_cast<float>(sum.z);
  to.outline(x, y) = static_cast<float>(car);
}

Rendering rendered(const Options& o) {
  const headlamp::Scene scene(o.distance_m, o.yaw_deg);
  Rendering rendering(o);
  std::atomic<int> next_row = 0;
  const auto work = [&] {
    for (int y = next_row++; y < o.height; y = next_row++)
      for (int x = 0; x < o.width; ++x) render_pixel(scene, o, x, y, rendering);
  };
  const auto machine = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::jthread> others;
  for (int i = 1; i < (o.threads > 0 ? o.threads : machine); ++i) others.emplace_back(work);
  work();
  others.clear();
  return rendering;
}

void print_places(const Options& o) {
  std::printf("[[vehicles]]\nname = \"car\"\nposition_m = [0, %.4g, %.4g]\nyaw_deg = %.4g\n",
              -o.eye_height_m, o.distance_m, o.yaw_deg);
  for (const auto& [name, light] :
       {std::pair{"high", headlamp::kHighBeam}, std::pair{"low", headlamp::kLowBeam}})
    for (const int side : {1, -1}) {
      const Vec3 p = headlamp::place_on_front(light);
      std::printf("# %s beam, %s\nposition_m = [%.3f, %.3f, %.3f]\n", name,
                  side > 0 ? "right" : "left", side * p.x, p.y, p.z);
    }
}

bool parse_number(const char* text, double low, double high, double& value) {
  const char* const end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, value);
  return error == std::errc{} && stop == end && value >= low && value <= high;
}

bool parse_option(const std::string& name, const char* text, Options& o) {
  const auto number = [&](double low, double high, auto& value) {
    double parsed = 0;
    if (!parse_number(text, low, high, parsed)) return false;
    value = static_cast<std::remove_reference_t<decltype(value)>>(parsed);
    return true;
  };
  if (name == "--yaw-deg") return number(-180, 180, o.yaw_deg);
  if (name == "--distance-m") return number(6, 500, o.distance_m);
  if (name == "--fov-deg") return number(0.5, 90, o.fov_deg);
  if (name == "--eye-height-m") return number(0.3, 4, o.eye_height_m);
  if (name == "--samples") return number(1, 16, o.samples);
  if (name == "--threads") return number(0, 1024, o.threads);
  if (name == "--outline") return o.outline = text, true;
  char rest = 0;
  return name == "--size" && std::sscanf(text, "%5dx%5d%c", &o.width, &o.height, &rest) == 2 &&
         std::min(o.width, o.height) >= 8 && std::max(o.width, o.height) <= 8192;
}

bool parse(int count, char** arguments, Options& o) {
  if (count < 2 || count % 2 != 0 || arguments[1][0] == '-') return false;
  o.output = arguments[1];
  for (int i = 2; i < count; i += 2)
    if (!parse_option(arguments[i], arguments[i + 1], o)) return false;
  return true;
}

void run(const Options& o) {
  Rendering rendering = rendered(o);
  glare::write_picture(o.output, rendering.picture);
  if (!o.outline.empty()) {
    rendering.picture.channels.fill(rendering.outline);
    glare::write_picture(o.outline, rendering.picture);
  }
  print_places(o);
}

}  // namespace

int main(int argument_count, char** arguments) {
  Options options;
  if (!parse(argument_count, arguments, options)) {
    std::fprintf(stderr,
                 "usage: render_car CAR.exr [--yaw-deg A] [--distance-m D] [--fov-deg F]\n"
                 "         [--eye-height-m H] [--size WxH] [--samples N] [--outline OUTLINE.exr]\n"
                 "         [--threads N]\n");
    return 2;
  }
  try {
    run(options);
  } catch (const glare::Error& error) {
    std::fprintf(stderr, "render_car: %s\n", error.what());
    return 1;
  }
}
