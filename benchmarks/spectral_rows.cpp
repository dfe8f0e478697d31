// Rows about the time of the spectral stage.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fftw_yardstick.h"
#include "machine.h"
#include "plain_wavelength_loop.h"
#include "rows.h"
#include "support/bins_pitch_case.h"
#include "support/lamps.h"

namespace glare::bench {

namespace {

constexpr int kRepetitions = 9;

/// A far field and what it is integrated to; made when it is first asked for.
class Stage {
 public:
  static const Stage& of(int output, int transform_length) {
    static std::map<std::pair<int, int>, Stage> stages;
    return stages.try_emplace({output, transform_length}, output, transform_length).first->second;
  }
  static const Stage& of(int output) { return of(output, output); }

  Stage(int output, int transform_length)
      : case_(output, transform_length), field_(case_.field(0)) {}

  XyzImage xyz(const Spectrum& lamp, int threads) const {
    return spectral_integral(field_, case_.grid, lamp, observer(), case_.range, threads, {});
  }
  /// Into pictures of before, as the transform's output is one of before.
  Time time(const Spectrum& lamp, int threads) const {
    return time_of([&] {
      spectral_integral(field_, case_.grid, lamp, observer(), case_.range, threads, {}, result_);
      benchmark::DoNotOptimize(result_);
    });
  }

  static const ColorMatchingFunctions& observer() {
    return color_matching_functions("cie1931-2deg");
  }
  const test::BinsPitchCase& bins_case() const { return case_; }
  const FarField& field() const { return field_; }

 private:
  test::BinsPitchCase case_;
  FarField field_;
  mutable XyzImage result_;
};

const Spectrum& lines() {
  static const Spectrum lamp = test::lamp_with_narrow_lines();
  return lamp;
}

FftwYardstick& yardstick(int n) {
  static std::map<int, FftwYardstick> yardsticks;
  return yardsticks.try_emplace(n, n).first->second;
}

/// The middle one of three times: after other work the first is often longer.
Time transform_time(int n) {
  FftwYardstick& transform = yardstick(n);
  std::vector<double> clock_s, cpu_s;
  for (int i = 0; i < 3; ++i) {
    const Time time = time_of([&] { transform.run(); });
    clock_s.push_back(time.clock_s);
    cpu_s.push_back(time.cpu_s);
  }
  return {median(clock_s), median(cpu_s)};
}

using NamedTime = std::pair<const char*, Time>;

/// Adds a / b.
void add_ratio(Measurement& m, const NamedTime& a, const NamedTime& b) {
  m.add_part(a.first, a.second.clock_s);
  m.add_part(b.first, b.second.clock_s);
  m.add(a.second.clock_s / b.second.clock_s);
}

/// The same of work of one thread.
void add_one_thread_ratio(Measurement& m, const NamedTime& a, const NamedTime& b) {
  add_ratio(m, a, b);
  m.add_by_cpu_time(a.second.cpu_s / b.second.cpu_s);
}

/// Of one thread.
void add_milliseconds(Measurement& m, const Time& time) {
  m.add(1e3 * time.clock_s);
  m.add_by_cpu_time(1e3 * time.cpu_s);
}

void add_ratio_to_transform(Rows& rows, const RowTitle& title, const std::string& id, int output,
                            int transform_length, bool slow) {
  rows.add(title, {id, kRepetitions, slow, true, [=](Measurement& m) {
                     const Stage& stage = Stage::of(output, transform_length);
                     add_one_thread_ratio(m, {"spectral stage", stage.time(lines(), 1)},
                                          {"transform", transform_time(transform_length)});
                   }});
}

void add_transform_rows(Rows& rows, Scale scaled) {
  const int output = scaled(4096), twice = scaled(8192);
  add_ratio_to_transform(rows,
                         {"spectral stage ÷ real-to-complex transform of the same padded size, "
                          "4096², bins' own pitch, one thread, 1 nm lamp with lines",
                          "×", 4, 2.5},
                         "spectral/transform", output, output, false);
  add_ratio_to_transform(rows, {"the same with the transform twice the output", "×", 1.5, 1},
                         "spectral/transform_twice", output, twice, true);
  rows.add({"that transform itself, 4096², one thread", "ms", {}, {}},
           {"transform/4096", kRepetitions, false, true,
            [=](Measurement& m) { add_milliseconds(m, transform_time(output)); }});
  rows.add({"that transform itself, 8192², one thread", "ms", {}, {}},
           {"transform/8192", kRepetitions, true, true,
            [=](Measurement& m) { add_milliseconds(m, transform_time(twice)); }});
}

/// The plain loop is no yardstick unless it computes the same: point values for pixel means, 440
/// wavelengths, bilinear.
std::string agreement(const XyzImage& plain, const XyzImage& found) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < plain[1].values().size(); i += 97)
    differences.push_back(std::abs(plain[1].values()[i] / found[1].values()[i] - 1));
  char text[120];
  std::snprintf(text, sizeof text, "the two pictures' luminances differ by %.2g %% (median)",
                100 * median(differences));
  return text;
}

void add_plain_loop_row(Rows& rows, Scale scaled) {
  const int size = scaled(2048);
  rows.add({"plain 440-wavelength loop ÷ spectral stage, 2048², one thread", "×", 70, 150, true},
           {"spectral/plain_loop", 2, true, false, [=](Measurement& m) {
              const Stage& stage = Stage::of(size);
              static const PlainFarField plain_field = plain_far_field(stage.field());
              XyzImage plain;
              const Time plain_time = time_of([&] {
                plain = plain_wavelength_loop(plain_field, stage.bins_case().grid, lines(),
                                              Stage::observer(), stage.bins_case().range, 440);
              });
              std::vector<double> clock_s, cpu_s;
              for (int i = 0; i < kRepetitions; ++i) {
                const Time time = stage.time(lines(), 1);
                clock_s.push_back(time.clock_s);
                cpu_s.push_back(time.cpu_s);
              }
              add_one_thread_ratio(m, {"plain loop", plain_time},
                                   {"spectral stage", {median(clock_s), median(cpu_s)}});
              m.set_remark(agreement(plain, stage.xyz(lines(), 1)));
            }});
}

void add_table_rows(Rows& rows, Scale scaled, int full_size, bool slow) {
  const int size = scaled(full_size);
  const std::string what =
      full_size == 2048 ? "ten times as many rows in the lamp's table: more time, 2048², one thread"
                        : "the same at 512²";
  const bool wanted = full_size == 2048;
  rows.add({what, "%", wanted ? std::optional(10.) : std::nullopt,
            wanted ? std::optional(0.) : std::nullopt},
           {"spectral/table_rows/" + std::to_string(full_size), 2 * kRepetitions, slow, true,
            [=](Measurement& m) {
              static const Spectrum fine = test::resampled(lines(), 0.1);
              const Stage& stage = Stage::of(size);
              const Time fine_time = stage.time(fine, 1), time = stage.time(lines(), 1);
              m.add_part("0.1 nm", fine_time.clock_s);
              m.add_part("1 nm", time.clock_s);
              m.add(100 * (fine_time.clock_s / time.clock_s - 1));
              m.add_by_cpu_time(100 * (fine_time.cpu_s / time.cpu_s - 1));
            }});
}

}  // namespace

void add_spectral_rows(Rows& rows, Scale scaled) {
  add_transform_rows(rows, scaled);
  const int size = scaled(1024), large = scaled(4096), small = scaled(512);
  rows.add({"spectral stage at 1024², one thread", "ms", 25, 12},
           {"spectral/1024", 2 * kRepetitions, false, true,
            [=](Measurement& m) { add_milliseconds(m, Stage::of(size).time(lines(), 1)); }});
  add_plain_loop_row(rows, scaled);
  add_table_rows(rows, scaled, 2048, false);
  add_table_rows(rows, scaled, 512, false);
  rows.add({"two threads against one, 4096²", "×", 1.7, {}, true},
           {"spectral/two_threads", kRepetitions, false, true, [=](Measurement& m) {
              const Stage& stage = Stage::of(large);
              add_ratio(m, {"one thread", stage.time(lines(), 1)},
                        {"two threads", stage.time(lines(), 2)});
              m.set_remark(cores_text() + " in between, with this program's own");
            }});
  rows.add({"another lamp on the same far field, 512², two threads", "ms", 5, 2},
           {"spectral/another_lamp", 4 * kRepetitions, false, true,
            [=](Measurement& m) { m.add(1e3 * Stage::of(small).time(lines(), 2).clock_s); }});
}

}  // namespace glare::bench
