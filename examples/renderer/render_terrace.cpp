// A terrace at night by path tracing, with the glare of its lamps in an eye.
//   render_terrace OUT [--frames N] [--size WxH] [--samples N] [--fov-deg F]
//                  [--template TEMPLATE.exr] [--threads N]
// Writes OUT_0001.exr and so on, in cd/m^2: R G B as rendered, and in the layer "glare" what an eye
// adds to it (and takes away: their sum is what it sees). OUT_0001.png shows the sum.
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

#include "path_tracing.h"

namespace {

using renderer::Vec3;

struct Options {
  int frames = 1;
  int width = 640, height = 360;
  int samples = 7;      ///< Across a pixel, and down it.
  double fov_deg = 40;  ///< From left to right.
  int threads = 0;
  std::string output, template_path;
};

glare::Picture empty_picture(const Options& o) {
  glare::Picture picture;
  for (auto& channel : picture.channels) channel = glare::Image<float>(o.width, o.height);
  picture.color_space = renderer::working_space();
  return picture;
}

/// Of a pinhole at eye height, that looks a little down.
renderer::Ray camera_ray(const Options& o, double column, double row) {
  constexpr double kTilt_rad = 0.06;
  const double focal_length_px = 0.5 * o.width / std::tan(o.fov_deg * std::numbers::pi / 360);
  const double right = (column - 0.5 * o.width) / focal_length_px;
  const double up = (0.5 * o.height - row) / focal_length_px;
  return {{0, 1.45, -2.4},
          vectors::normalized({right, up * std::cos(kTilt_rad) - std::sin(kTilt_rad),
                               std::cos(kTilt_rad) + up * std::sin(kTilt_rad)})};
}

void render_pixel(const renderer::Scene& scene, const Options& o, int x, int y,
                  glare::Picture& picture) {
  renderer::Random random(static_cast<std::uint64_t>(y) * 65536 + static_cast<std::uint64_t>(x));
  Vec3 sum;
  for (int i = 0; i < o.samples * o.samples; ++i) {
    const double column = x + (i % o.samples + random.next()) / o.samples;
    const double row = y + (i / o.samples + random.next()) / o.samples;
    sum = sum + renderer::traced_luminance(scene, camera_ray(o, column, row), random);
  }
  const double weight = 1.0 / (o.samples * o.samples);
  picture.channels[0](x, y) = static_cast<float>(weight * sum.x);
  picture.channels[1](x, y) = static_cast<float>(weight * sum.y);
  picture.channels[2](x, y) = static_cast<float>(weight * sum.z);
}

glare::Picture rendered(const renderer::Scene& scene, const Options& o) {
  glare::Picture picture = empty_picture(o);
  std::atomic<int> next_row = 0;
  const auto work = [&] {
    for (int y = next_row++; y < o.height; y = next_row++)
      for (int x = 0; x < o.width; ++x) render_pixel(scene, o, x, y, picture);
  };
  const auto machine = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::jthread> others;
  for (int i = 1; i < (o.threads > 0 ? o.threads : machine); ++i) others.emplace_back(work);
  work();
  others.clear();
  return picture;
}

/// The one that is given, or the built-in eye's with its straylight. Of daylight: each light in the
/// picture keeps its own colour.
glare::GlareTemplate eye_template(const Options& o) {
  if (!o.template_path.empty()) return glare::read_template(o.template_path);
  glare::TemplateOptions options;
  options.width = options.height = 640;
  options.field_of_view_deg = std::min(20.0, 2 * o.fov_deg);
  options.scatter = glare::Straylight{};
  options.threads = o.threads;
  const glare::Spectrum lamp = *glare::find_lamp("D65");
  const glare::Aperture eye =
      glare::draw_template_eye({}, options, glare::effective_range(lamp, options));
  return glare::make_template(eye, lamp, options, "D65");
}

/// The eye ready for all frames.
glare::GlareFilter eye_filter(const Options& o) {
  glare::PixelKernelOptions kernel;
  kernel.reach_x_px = o.width - 1;
  kernel.reach_y_px = o.height - 1;
  glare::GlareFilterOptions filter;
  filter.threads = o.threads;
  return {glare::pixel_kernel(eye_template(o), glare::scale_of_perspective(o.fov_deg, o.width),
                              renderer::working_space(), kernel),
          o.width, o.height, filter};
}

void add(const glare::Picture& more, glare::Picture& to) {
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < to.channels[k].values().size(); ++i)
      to.channels[k].values()[i] += more.channels[k].values()[i];
}

void write_display(const std::string& path, const glare::Picture& picture) {
  glare::ToneMapping mapping;
  mapping.adaptation_luminance = 0.6;  // cd/m^2
  mapping.gamma = 1.1;
  glare::write_file_atomically(path, glare::encode_png_rgb8(glare::tone_mapped(picture, mapping)));
}

void write_frame(const std::string& name, glare::Picture& beauty, const glare::Picture& glare) {
  const glare::PictureLayer layers[] = {{"", &beauty}, {"glare", &glare}};
  glare::write_picture_layers(name + ".exr", layers);
  add(glare, beauty);
  write_display(name + ".png", beauty);
}

void run(const Options& o) {
  const glare::GlareFilter filter = eye_filter(o);
  glare::ApplyGlareOptions apply;
  apply.only_glare = true;
  apply.threads = o.threads;
  for (int frame = 0; frame < o.frames; ++frame) {
    const renderer::Scene scene(o.frames > 1 ? static_cast<double>(frame) / (o.frames - 1) : 0.0);
    glare::Picture beauty = rendered(scene, o);
    glare::Picture glare = beauty;
    glare::apply_glare(glare, filter, apply);
    char number[16];
    std::snprintf(number, sizeof number, "_%04d", frame + 1);
    write_frame(o.output + number, beauty, glare);
  }
}

template <typename Number>
bool parse_number(const char* text, Number low, Number high, Number& value) {
  const char* const end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, value);
  return error == std::errc{} && stop == end && value >= low && value <= high;
}

bool parse_option(const std::string& name, const char* text, Options& o) {
  if (name == "--frames") return parse_number(text, 1, 9999, o.frames);
  if (name == "--samples") return parse_number(text, 1, 64, o.samples);
  if (name == "--threads") return parse_number(text, 0, 1024, o.threads);
  if (name == "--fov-deg") return parse_number(text, 5.0, 120.0, o.fov_deg);
  if (name == "--template") return o.template_path = text, true;
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

}  // namespace

int main(int argument_count, char** arguments) {
  Options options;
  if (!parse(argument_count, arguments, options)) {
    std::fprintf(stderr,
                 "usage: render_terrace OUT [--frames N] [--size WxH] [--samples N] [--fov-deg F]\n"
                 "                      [--template TEMPLATE.exr] [--threads N]\n");
    return 2;
  }
  try {
    run(options);
  } catch (const glare::Error& error) {
    std::fprintf(stderr, "render_terrace: %s\n", error.what());
    return 1;
  }
}
