// Prints the benchmark table: see docs/performance.md.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "machine.h"
#include "rows.h"
#include "table.h"

namespace {

using glare::bench::Rows;

struct Options {
  std::string json_file;
  bool quick = false;
  int shrink = 1;
};

constexpr const char* kUsage =
    "usage: glare_benchmarks [--json FILE] [--quick] [--shrink N] [--benchmark_filter=REGEX]\n"
    "  --json FILE  also write the rows as a JSON list\n"
    "  --quick      leave out the slowest rows\n"
    "  --shrink N   divide the pictures' sides by N, to try this program: the values are not "
    "those\n"
    "               of the table\n";

void print_usage() { std::fputs(kUsage, stdout); }

[[noreturn]] void fail_usage() {
  std::fputs(kUsage, stderr);
  std::exit(2);
}

/// Takes its own options; Google Benchmark's (--benchmark_...) have been taken before.
Options options_from(const std::vector<std::string_view>& arguments) {
  Options out;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool last = i + 1 == arguments.size();
    if (arguments[i] == "--quick")
      out.quick = true;
    else if (arguments[i] == "--json" && !last)
      out.json_file = arguments[++i];
    else if (arguments[i] == "--shrink" && !last)
      out.shrink = std::atoi(std::string(arguments[++i]).c_str());
    else
      fail_usage();
  }
  if (out.shrink < 1 || out.shrink > 16) fail_usage();
  return out;
}

/// Says on stderr what has been measured, as it goes.
class ProgressReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const auto value = run.counters.find("value");
      if (value != run.counters.end())
        std::fprintf(stderr, "%-60s %.4g\n", run.benchmark_name().c_str(), value->second.value);
    }
  }
};

/// Throws where the file can't be written; an empty text, before the work, tells.
void write(const std::string& file_name, const std::string& text) {
  std::ofstream file(file_name);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(file_name + " can't be written");
}

int run(const Options& options) {
  if (!options.json_file.empty()) write(options.json_file, "");
  Rows rows(options.quick);
  const glare::bench::Scale scaled{options.shrink};
  glare::bench::add_spectral_rows(rows, scaled);
  glare::bench::add_template_rows(rows, scaled);
  glare::bench::add_scene_rows(rows, scaled);
  glare::bench::add_picture_rows(rows, scaled);
  glare::bench::add_convolution_rows(rows, scaled);
  glare::bench::add_program_rows(rows);
  glare::bench::add_accuracy_rows(rows, scaled);

  const std::string machine = glare::bench::machine_text();  // Before it is busy with this.
  ProgressReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  if (options.shrink != 1)
    std::printf("All sides divided by %d: these are not the table's values.\n\n", options.shrink);
  std::printf("%s\n%s", machine.c_str(), glare::bench::markdown(rows.rows()).c_str());

  if (!options.json_file.empty()) write(options.json_file, glare::bench::json(rows.rows()));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv, print_usage);
  try {
    return run(options_from({argv + 1, argv + argc}));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "glare_benchmarks: error: %s\n", error.what());
    return 1;
  }
}
