// A night street with an oncoming car, as a renderer would add glare to it: each lamp's light at
// the eye, in lux, times the template per steradian is the veil's luminance in cd/m^2.
//   night_scene SCENE.png APERTURE.png [WIDTH]
#include <glare/glare.h>
#include <glare/glare_io.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace {

constexpr double kFieldOfView_deg = 8;  // Across the picture.

struct Lamp {
  double x, y;  ///< Place in the picture, as shares of its width from the upper left corner.
  double illuminance_lux;  ///< At the eye.
};

using Rgb = std::array<float, 3>;
using Picture = glare::Image<Rgb>;

/// A street at night without any glare, in cd/m^2, at shares of the picture's width.
Rgb street(double x, double y) {
  constexpr double kHorizon = 0.236, kBottom = 0.5625;
  if (y < kHorizon) {
    const double ridge = kHorizon - 0.028 - 0.014 * std::sin(10 * x) - 0.006 * std::sin(51 * x);
    const auto sky = static_cast<float>(0.006 + 0.03 * std::exp((y - kHorizon) / 0.1));
    return y > ridge ? Rgb{0.002f, 0.0022f, 0.002f} : Rgb{0.7f * sky, 0.85f * sky, 1.3f * sky};
  }
  const double depth = (y - kHorizon) / (kBottom - kHorizon);  // 0 far, 1 near
  const double across = (x - 0.46) / (0.02 + 0.75 * depth);
  const bool marking = std::abs(across) < 0.012 || std::abs(std::abs(across) - 0.62) < 0.014;
  const bool road = std::abs(across) < 0.68;
  const auto ground = static_cast<float>((road ? 0.05 : 0.02) * (0.35 + depth));
  const float light = marking ? 8 * ground : ground;
  return {1.05f * light, light, 0.8f * light};
}

Picture street_picture(int width) {
  Picture picture(width, width * 9 / 16);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < width; ++x)
      picture(x, y) = street(static_cast<double>(x) / width, static_cast<double>(y) / width);
  return picture;
}

void add_glare(Picture& picture, const glare::GlareTemplate& kernel, const Lamp& lamp) {
  const auto center = kernel.center_px();
  const int left = center[0] - static_cast<int>(lamp.x * picture.width());
  const int top = center[1] - static_cast<int>(lamp.y * picture.width());
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      for (std::size_t k = 0; k < 3; ++k)
        picture(x, y)[k] +=
            static_cast<float>(lamp.illuminance_lux * kernel.channels[k](x + left, y + top));
}

/// A template as fine as the picture, and twice its size, so that it reaches across all of it.
glare::GlareTemplate kernel_for(const Picture& picture, const glare::Aperture& eye) {
  glare::TemplateOptions options;
  options.width = 2 * picture.width();
  options.height = 2 * picture.height();
  options.field_of_view_deg = 2 * kFieldOfView_deg;
  options.normalization = glare::Normalization::absolute;
  return glare::make_template(eye, *glare::find_lamp("hid"), options, "hid");
}

void write_aperture(const char* path, const glare::Aperture& eye) {
  const int step = eye.transmittance.width() / 360;
  const int size = eye.transmittance.width() / step;
  glare::Image<float> small(size, size);
  for (int y = 0; y < small.height(); ++y)
    for (int x = 0; x < small.width(); ++x)
      for (int i = 0; i < step * step; ++i)
        small(x, y) += eye.transmittance(x * step + i % step, y * step + i / step) /
                       static_cast<float>(step * step);
  glare::write_file_atomically(path, glare::encode_png_gray16(small));
}

void run(const char* scene_path, const char* aperture_path, int width) {
  constexpr double kReach_rad = kFieldOfView_deg * std::numbers::pi / 180;
  const glare::Aperture eye = glare::draw_eye({}, 380e-6 / (2 * kReach_rad));
  write_aperture(aperture_path, eye);

  Picture picture = street_picture(width);
  const glare::GlareTemplate kernel = kernel_for(picture, eye);
  for (const Lamp& lamp :
       {Lamp{0.578, 0.272, 0.06}, Lamp{0.663, 0.272, 0.06}, Lamp{0.25, 0.15, 0.004}})
    add_glare(picture, kernel, lamp);

  const glare::SigmoidToneMap tone_map{2.0, 1.3};  // half of white at 2 cd/m^2
  for (Rgb& pixel : picture.values()) pixel = tone_map(pixel);
  glare::write_file_atomically(scene_path, glare::encode_png_rgb8(picture));
}

}  // namespace

int main(int argument_count, char** arguments) {
  const int width = argument_count == 4 ? std::atoi(arguments[3]) : 640;
  if (argument_count < 3 || argument_count > 4 || width < 32 || width > 4096) {
    std::fprintf(stderr, "usage: night_scene SCENE.png APERTURE.png [WIDTH from 32 to 4096]\n");
    return 2;
  }
  try {
    run(arguments[1], arguments[2], width);
  } catch (const glare::Error& error) {
    std::fprintf(stderr, "night_scene: %s\n", error.what());
    return 1;
  }
}
