// A night street with an oncoming car, as a renderer would add glare to it: each lamp's light at
// the eye, in lux, times the template per steradian is the veil's luminance in cd/m^2.
//   night_scene SCENE.png APERTURE.png
#include <glare/glare.h>
#include <glare/glare_io.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace {

constexpr int kWidth = 640, kHeight = 360;
constexpr double kFieldOfView_deg = 8;

struct Lamp {
  int x, y;
  double illuminance_lux;  ///< At the eye.
};

using Rgb = std::array<float, 3>;

/// Luminance and tint of a street at night without any glare, in cd/m^2.
Rgb street(int x, int y) {
  const double horizon = 0.42 * kHeight;
  if (y < horizon) {
    const double ridge = horizon - 18 - 9 * std::sin(x * 0.016) - 4 * std::sin(x * 0.08);
    const auto sky = static_cast<float>(0.006 + 0.03 * std::exp((y - horizon) / 60));
    return y > ridge ? Rgb{0.002f, 0.0022f, 0.002f} : Rgb{0.7f * sky, 0.85f * sky, 1.3f * sky};
  }
  const double depth = (y - horizon) / (kHeight - horizon);  // 0 far, 1 near
  const double across = (x - 0.46 * kWidth) / (0.02 * kWidth + 0.75 * kWidth * depth);
  const bool marking = std::abs(across) < 0.012 || std::abs(std::abs(across) - 0.62) < 0.014;
  const bool road = std::abs(across) < 0.68;
  const auto ground = static_cast<float>((road ? 0.05 : 0.02) * (0.35 + depth));
  const float light = marking ? 8 * ground : ground;
  return {1.05f * light, light, 0.8f * light};
}

void add_glare(glare::Image<Rgb>& picture, const glare::GlareTemplate& kernel, const Lamp& lamp) {
  const auto center = kernel.center_px();
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (std::size_t k = 0; k < 3; ++k)
        picture(x, y)[k] +=
            static_cast<float>(lamp.illuminance_lux *
                               kernel.channels[k](x - lamp.x + center[0], y - lamp.y + center[1]));
}

/// A template as fine as the picture, and twice its size, so that it reaches across all of it.
glare::GlareTemplate kernel_for_picture(const glare::Aperture& eye) {
  glare::TemplateOptions options;
  options.width = 2 * kWidth;
  options.height = 2 * kHeight;
  options.field_of_view_deg = 2 * kFieldOfView_deg;
  options.normalization = glare::Normalization::absolute;
  return glare::make_template(eye, *glare::find_lamp("hid"), options, "hid");
}

void write_aperture(const char* path, const glare::Aperture& eye) {
  glare::Image<float> small(360, 360);
  const int step = eye.transmittance.width() / small.width();
  for (int y = 0; y < small.height(); ++y)
    for (int x = 0; x < small.width(); ++x)
      for (int i = 0; i < step * step; ++i)
        small(x, y) += eye.transmittance(x * step + i % step, y * step + i / step) /
                       static_cast<float>(step * step);
  glare::write_file_atomically(path, glare::encode_png_gray16(small));
}

void run(const char* scene_path, const char* aperture_path) {
  constexpr double kReach_rad = kFieldOfView_deg * std::numbers::pi / 180;
  const glare::Aperture eye = glare::draw_eye({}, 380e-6 / (2 * kReach_rad));
  write_aperture(aperture_path, eye);

  glare::Image<Rgb> picture(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) picture(x, y) = street(x, y);
  const glare::GlareTemplate kernel = kernel_for_picture(eye);
  for (const Lamp& lamp : {Lamp{370, 174, 0.06}, Lamp{424, 174, 0.06}, Lamp{160, 96, 0.004}})
    add_glare(picture, kernel, lamp);

  const glare::SigmoidToneMap tone_map{2.0, 1.3};  // half of white at 2 cd/m^2
  for (Rgb& pixel : picture.values()) pixel = tone_map(pixel);
  glare::write_file_atomically(scene_path, glare::encode_png_rgb8(picture));
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 3) {
    std::fprintf(stderr, "usage: night_scene SCENE.png APERTURE.png\n");
    return 2;
  }
  try {
    run(arguments[1], arguments[2]);
  } catch (const glare::Error& error) {
    std::fprintf(stderr, "night_scene: %s\n", error.what());
    return 1;
  }
}
