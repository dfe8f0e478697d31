#include "apply/picture_scale.h"

#include <cmath>
#include <cstdio>

#include "glare/base/error.h"
#include "glare/base/units.h"

namespace glare::tool {

namespace {

constexpr double kDegreesPerRadian = 1 / kRadPerDeg;
// A field of so few pixels is a blur of the nearest ones.
constexpr double kFewestPixels = 5;
// A field of so little of the picture looks like no glare at all.
constexpr double kLeastShare = 0.02;
// Where within its pixel a template's light lies isn't known: on finer pixels it is smeared.
constexpr double kCoarsest = 2.5;
// Half of 40 degrees: the middle's pixels of a perspective picture are 4 % wider than on average.
constexpr double kWide_deg = 40;

template <typename... Numbers>
std::string text(const char* format, Numbers... numbers) {
  char result[400];
  std::snprintf(result, sizeof result, format, numbers...);
  return result;
}

ScaledPicture told_scale(const PictureDocument& document, const std::string& file) {
  const auto told = document.pixel_pitch();
  if (!told)
    throw OptionError(file +
                      " doesn't tell its angles: expected --fov-deg, across its width, or "
                      "--pixel-deg");
  if (!(told->pitch_rad > 0 && told->pitch_rad <= 1))
    throw InputError(file, text("its %s: %g degrees per pixel; give --fov-deg or --pixel-deg",
                                told->source.c_str(), told->pitch_rad * kDegreesPerRadian));
  return {{told->pitch_rad, 1}, told->source};
}

}  // namespace

ScaledPicture scale_of(const PictureDocument& document, const std::string& file,
                       const ApplyArguments& a) {
  ScaledPicture scaled;
  if (a.pixel_deg)
    scaled = {{*a.pixel_deg / kDegreesPerRadian, 1}, "--pixel-deg"};
  else if (a.fov_deg && a.perspective)
    scaled = {scale_of_perspective(*a.fov_deg, document.display_width()),
              "--fov-deg and --perspective"};
  else if (a.fov_deg)
    scaled = {scale_of_field_of_view(*a.fov_deg, document.display_width()), "--fov-deg"};
  else
    scaled = told_scale(document, file);
  const double aspect = document.pixel_aspect();
  if (!(aspect >= 1.0 / 64 && aspect <= 64))
    throw InputError(file, text("its pixels' aspect is %g, expected 1/64 to 64", aspect));
  if (!(scaled.scale.pitch_rad <= 1))
    throw OptionError(text("the picture's pixels are %g degrees wide, expected at most 57",
                           scaled.scale.pitch_rad * kDegreesPerRadian));
  scaled.scale.pixel_aspect = aspect;
  return scaled;
}

void tell_scale(const ScaledPicture& scaled, const GlareTemplate& t,
                const PictureDocument& document, const ApplyArguments& a, const Console& console) {
  const double pitch_deg = scaled.scale.pitch_rad * kDegreesPerRadian;
  const double template_deg = t.pixel_pitch_deg(), field_deg = template_deg * t.width();
  const double width_px = field_deg / pitch_deg;
  const double height_px = template_deg * t.height() / pitch_deg * scaled.scale.pixel_aspect;
  console.tell(text("the picture has %.6g degrees per pixel (%s), the template %.6g", pitch_deg,
                    scaled.source.c_str(), template_deg));
  console.tell(
      text("the template's field is %.4g x %.4g pixels of the picture and holds %.4g %% of "
           "the light; the rest stays where it is",
           width_px, height_px, 100 * t.captured_energy));
  if (width_px < kFewestPixels || height_px < kFewestPixels)
    console.warn(
        text("the template's field, %.4g degrees wide, is only %.3g x %.3g pixels of the "
             "picture: its glare is hardly to be seen",
             field_deg, width_px, height_px));
  else if (width_px < kLeastShare * document.picture().width())
    console.warn(
        text("the template's field, %.4g degrees wide, is only %.2g %% of the picture's "
             "width; glare template --fov-deg makes wider ones",
             field_deg, 100 * width_px / document.picture().width()));
  if (template_deg > kCoarsest * pitch_deg)
    console.warn(text(
        "the template's pixels are %.3g times as wide as the picture's, which blurs its lights; "
        "glare template with a --size of more pixels makes finer ones",
        template_deg / pitch_deg));
  if (a.fov_deg && !a.perspective && *a.fov_deg > kWide_deg)
    console.warn(text(
        "--fov-deg %g is divided among the pixels evenly; in the middle of a "
        "perspective picture they are %.3g %% of that: --perspective",
        *a.fov_deg,
        100 * 2 * std::tan(*a.fov_deg / kDegreesPerRadian / 2) / (*a.fov_deg / kDegreesPerRadian)));
  if (t.captured_energy < 0.5)
    console.warn(
        text("only %.3g %% of the light falls into the template's field; the rest stays "
             "where it is",
             100 * t.captured_energy));
}

}  // namespace glare::tool
