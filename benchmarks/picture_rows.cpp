// Rows about pictures.
#include <benchmark/benchmark.h>

#include <cmath>

#include "glare/picture/tone_mapping.h"
#include "rows.h"

namespace glare::bench {

namespace {

/// From left to right brighter by 3.5 decades, each pixel of another colour.
Picture bright_picture(int width, int height) {
  Picture picture;
  picture.channels.fill(Image<float>(width, height));
  unsigned state = 1;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (auto& channel : picture.channels) {
        state = state * 1664525u + 1013904223u;
        const double share = 0.7 + 0.6 * (state >> 8) / (1 << 24);
        channel(x, y) = static_cast<float>(std::pow(10, -2 + 3.5 * x / width) * share);
      }
  return picture;
}

}  // namespace

void add_picture_rows(Rows& rows, Scale scaled) {
  const int width = scaled(1920), height = scaled(1080);
  rows.add({"`tone_mapped`, sigmoid of the luminance, 1920 × 1080, two threads", "ms", 10, 5},
           {"tone_mapped/1080", 15, false, true, [=](Measurement& m) {
              static const Picture picture = bright_picture(width, height);
              m.add(1e3 * seconds([&] { benchmark::DoNotOptimize(tone_mapped(picture, {}, 2)); }));
            }});
}

}  // namespace glare::bench
