// Rows about pictures with the glare of all their pixels.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include "fftw_yardstick.h"
#include "glare/convolution/glare_filter.h"
#include "glare/diffraction/fourier_transform.h"
#include "rows.h"

namespace glare::bench {

namespace {

constexpr int kThreads = 2;

/// A halo that is 0.9 of the light, as wide as a template of so many pixels.
PixelKernel halo(int size) {
  PixelKernel kernel;
  Image<float> shares(size, size);
  double sum = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double r = std::hypot(x - size / 2, y - size / 2), share = 1 / (1 + r * r);
      shares(x, y) = static_cast<float>(share);
      sum += share;
    }
  kernel.captured.fill(0.9);
  kernel.kept.fill(0.1);
  for (float& share : shares.values())
    share = static_cast<float>(kernel.captured[0] / sum * static_cast<double>(share));
  kernel.channels.fill(shares);
  return kernel;
}

/// Dim, with a light a million times as bright in one of a thousand pixels.
Picture night(int width, int height) {
  Picture picture;
  picture.channels.fill(Image<float>(width, height));
  unsigned state = 1;
  for (auto& channel : picture.channels)
    for (float& value : channel.values()) {
      state = state * 1664525u + 1013904223u;
      value = (state >> 8) % 1000 == 0 ? 1e4f : 1e-2f;
    }
  return picture;
}

/// A picture that gets its glare again and again.
struct Frame {
  Picture picture;
  GlareFilter filter;

  Frame(int width, int height, int kernel_size, const GlareFilterOptions& options)
      : picture(night(width, height)), filter(halo(kernel_size), width, height, options) {}

  double time_s() {
    ApplyGlareOptions options;
    options.threads = kThreads;
    return seconds([&] { apply_glare(picture, filter, options); });
  }
};

}  // namespace

void add_convolution_rows(Rows& rows, Scale scaled) {
  // A template of 1024 pixels is a kernel of 1023, since a kernel's size is odd.
  const int width = scaled(1920), height = scaled(1080), size = scaled(1024) - 1;
  const auto frame = [=]() -> Frame& {
    static Frame result(width, height, size, {Edge::black, kThreads, 0});
    return result;
  };
  rows.add({"`apply_glare`, 1920 × 1080, three channels, a template of 1024², over FFTW's real "
            "transform of the padded size there and back, two threads each",
            "×", 4, 2},
           {"convolution/ratio", 11, false, true, [=](Measurement& m) {
              static FftwThereAndBack yardstick(fast_transform_length(width + size / 2),
                                                fast_transform_length(height + size / 2), kThreads);
              const double transforms_s = seconds([&] { yardstick.run(); });
              const double apply_s = frame().time_s();
              m.add(apply_s / transforms_s);
              m.add_part("apply_glare", apply_s);
              m.add_part("FFTW there and back", transforms_s);
            }});
  rows.add({"the same: a frame", "ms", {}, {}},
           {"convolution/frame", 11, false, true,
            [=](Measurement& m) { m.add(1e3 * frame().time_s()); }});
  rows.add({"the same, beyond the border its own values", "ms", {}, {}},
           {"convolution/extend", 11, false, true, [=](Measurement& m) {
              static Frame extended(width, height, size, {Edge::extend, kThreads, 0});
              m.add(1e3 * extended.time_s());
            }});
  rows.add({"making its `GlareFilter`", "ms", {}, {}},
           {"convolution/prepare", 5, false, true, [=](Measurement& m) {
              const PixelKernel kernel = halo(size);
              const GlareFilterOptions options{Edge::black, kThreads, 0};
              m.add(1e3 * seconds([&] {
                      benchmark::DoNotOptimize(GlareFilter(kernel, width, height, options));
                    }));
            }});
  rows.add(
      {"`apply_glare`, 8192 × 4096, in blocks within 400 MB", "ms", {}, {}},
      {"convolution/blocks", 3, true, false, [=](Measurement& m) {
         static Frame large(scaled(8192), scaled(4096), size, {Edge::black, kThreads, 400'000'000});
         m.add(1e3 * large.time_s());
       }});
}

}  // namespace glare::bench
