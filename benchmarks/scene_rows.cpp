// Rows about frames with headlamps.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

#include "glare/base/units.h"
#include "glare/picture/tone_mapping.h"
#include "glare/scene/point_glare.h"
#include "rows.h"

namespace glare::bench {

namespace {

/// A halo over more than the picture's field: 60 degrees, 2048 pixels at full size.
GlareTemplate wide_template(int size) {
  GlareTemplate out;
  out.pixel_pitch_rad = 60. * kRadPerDeg / size;
  out.normalization = Normalization::absolute;
  out.per_steradian = 1;
  for (auto& channel : out.channels) {
    channel = Image<float>(size, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        channel(x, y) = static_cast<float>(1 / (1 + std::hypot(x - size / 2, y - size / 2)));
  }
  return out;
}

/// A full-HD picture of 50 degrees and a car's two lamps, whose glare reaches all of it.
class Frame {
 public:
  explicit Frame(Scale scaled)
      : camera_{scaled(1920), scaled(1080), 50},
        kernel_(wide_template(scaled(2048)), camera_, background_.color_space),
        lamps_{{{{-0.05, -0.01, 1}, 2, kernel_}, {{0.03, -0.01, 1}, 2, kernel_}}} {
    for (auto& channel : background_.channels)
      channel = Image<float>(camera_.width, camera_.height, 0.5f);
  }

  Time time_to_display(int threads) {
    return time_of([&] {
      with_glare(background_, camera_, lamps_, result_, threads);
      benchmark::DoNotOptimize(tone_mapped(result_, ToneMapping(), threads));
    });
  }
  Time time(int threads) {
    return time_of([&] {
      with_glare(background_, camera_, lamps_, result_, threads);
      benchmark::DoNotOptimize(result_);
    });
  }

 private:
  Camera camera_;
  Picture background_, result_;
  GlareKernel kernel_;
  std::array<PointOfLight, 2> lamps_;
};

}  // namespace

void add_scene_rows(Rows& rows, Scale scaled) {
  const auto frame = [=]() -> Frame& {
    static Frame result(scaled);
    return result;
  };
  rows.add({"a frame of two lamps, 1920 × 1080, with tone mapping, two threads", "ms", 30, {}},
           {"scene/frame", 20, false, true,
            [=](Measurement& m) { m.add(1e3 * frame().time_to_display(2).clock_s); }});
  rows.add({"of it the glare of both lamps, which reaches the whole frame", "ms", 20, {}},
           {"scene/two_lamps", 20, false, true,
            [=](Measurement& m) { m.add(1e3 * frame().time(2).clock_s); }});
  rows.add({"the same, one thread", "ms", {}, {}},
           {"scene/two_lamps_one_thread", 10, false, true, [=](Measurement& m) {
              const Time time = frame().time(1);
              m.add(1e3 * time.clock_s);
              m.add_by_cpu_time(1e3 * time.cpu_s);
            }});
}

}  // namespace glare::bench
