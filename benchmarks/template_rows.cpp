// Rows about make_template as a whole.
#include <benchmark/benchmark.h>

#include "eye_template.h"
#include "glare/aperture/eye.h"
#include "glare/base/units.h"
#include "glare/spectrum/lamps.h"
#include "rows.h"

namespace glare::bench {

namespace {

constexpr double kWidth_mm = 8;

}  // namespace

Aperture eight_millimetre_eye(int samples) {
  EyeParameters parameters;
  parameters.pupil.diameter_mm *= kWidth_mm / eye_picture_width_mm(parameters);
  return draw_eye(parameters, kWidth_mm / samples * (1 + 1e-9));
}

TemplateOptions eye_template_options(int size) {
  TemplateOptions out;
  out.width = out.height = size;
  out.field_of_view_deg = 380 * kMmPerNm / kWidth_mm * size / kRadPerDeg;
  out.color_space = xyz_color_space();
  out.normalization = Normalization::absolute;
  out.threads = 2;
  return out;
}

void add_template_rows(Rows& rows, Scale scaled) {
  const int size = scaled(1024);
  rows.add(
      {"`make_template`, aperture and output 1024², pixel = λ/width at 380 nm (8 mm, 2.79°), "
       "HP5, two threads, warm, transform included",
       "s", 0.3, 0.1},
      {"template/1024", 9, false, true, [=](Measurement& m) {
         static const Aperture aperture = eight_millimetre_eye(size);
         static const Spectrum lamp = *find_lamp("HP5");
         TemplateOptions options = eye_template_options(size);
         options.color_space = lin_rec709_color_space();
         options.normalization = Normalization::peak;
         m.add(seconds([&] { benchmark::DoNotOptimize(make_template(aperture, lamp, options)); }));
       }});
}

}  // namespace glare::bench
