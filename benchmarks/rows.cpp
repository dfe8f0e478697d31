#include "rows.h"

#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>

namespace glare::bench {

namespace {

double process_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

Time time_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  const double cpu_start_s = process_cpu_s();
  work();
  const double cpu_s = process_cpu_s() - cpu_start_s;
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), cpu_s};
}

double seconds(const std::function<void()>& work) { return time_of(work).clock_s; }

std::string Measurement::notes(const std::string& unit) const {
  char text[160];
  std::string out;
  if (values_.size() > 1) {
    const auto [smallest, largest] = std::minmax_element(values_.begin(), values_.end());
    std::snprintf(text, sizeof text, "%zu times, %.3g to %.3g%s%s", values_.size(), *smallest,
                  *largest, unit.empty() ? "" : " ", unit.c_str());
    out += text;
  }
  if (!by_cpu_time_.empty()) {
    std::snprintf(text, sizeof text, "; %.3g%s%s by CPU time", median(by_cpu_time_),
                  unit.empty() ? "" : " ", unit.c_str());
    out += text;
  }
  for (const auto& [name, parts_s] : parts_s_) {
    std::snprintf(text, sizeof text, "%s%s %.4g ms", out.empty() ? "" : "; ", name.c_str(),
                  1e3 * median(parts_s));
    out += text;
  }
  if (!remark_.empty()) out += (out.empty() ? "" : "; ") + remark_;
  return out;
}

void Rows::add(const RowTitle& title, const Method& method) {
  if (quick_ && method.slow) return;
  rows_.push_back(std::make_unique<Row>(Row{title, {}}));
  Row& row = *rows_.back();
  const auto run = [&row, method](benchmark::State& state) {
    if (method.warm_up) {
      Measurement forgotten;
      method.once(forgotten);
    }
    double spent_s = 0;
    for (auto _ : state) {
      const bool enough = spent_s > kLongest_s;
      const double once_s = enough ? 0 : seconds([&] { method.once(row.measurement); });
      spent_s += once_s;
      state.SetIterationTime(once_s);
    }
    state.counters["value"] = row.measurement.value();
  };
  benchmark::RegisterBenchmark(method.id.c_str(), run)
      ->Iterations(method.repetitions)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace glare::bench
