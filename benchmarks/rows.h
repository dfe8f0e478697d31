// The rows of the benchmark table and how they are measured.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glare::bench {

/// The middle one of the values, or the mean of the middle two; of at least one value.
double median(std::vector<double> values);

/// How long something takes, by the clock and by the time that this process' threads ran. For one
/// thread the second is what the first would be if other programs left it a core.
struct Time {
  double clock_s = 0;
  double cpu_s = 0;
};
Time time_of(const std::function<void()>& work);
/// By the clock.
double seconds(const std::function<void()>& work);

/// What a row says and what it should reach.
struct RowTitle {
  std::string what;
  std::string unit;
  std::optional<double> reach, stretch;
  bool at_least = false;  ///< Reach and stretch are lower bounds.
};

/// What was found out: a value for each repetition, and what else is worth telling.
class Measurement {
 public:
  void add(double value) { values_.push_back(value); }
  /// The same value from CPU times, for work of one thread.
  void add_by_cpu_time(double value) { by_cpu_time_.push_back(value); }
  /// A part of the value, such as one side of a ratio: its median is told beside the row.
  void add_part(const std::string& name, double part_s) { parts_s_[name].push_back(part_s); }
  void set_remark(const std::string& remark) { remark_ = remark; }

  bool empty() const { return values_.empty(); }
  double value() const { return median(values_); }
  /// Smallest and largest value, the value by CPU time, the parts' medians and the remark.
  std::string notes(const std::string& unit) const;

 private:
  std::vector<double> values_, by_cpu_time_;
  std::map<std::string, std::vector<double>> parts_s_;
  std::string remark_;
};

struct Row {
  RowTitle title;
  Measurement measurement;
};

/// How a row is measured. `once` is called `repetitions` times and adds one value each time; it
/// isn't called again once the row has taken `kLongest_s`.
struct Method {
  std::string id;  ///< For --benchmark_filter.
  int repetitions = 1;
  bool slow = false;     ///< Left out with --quick.
  bool warm_up = false;  ///< Call once more at first and forget what it found.
  std::function<void(Measurement&)> once;
};

constexpr double kLongest_s = 30;

/// All rows, in the table's order; each is a Google Benchmark.
class Rows {
 public:
  explicit Rows(bool quick) : quick_(quick) {}

  void add(const RowTitle& title, const Method& method);
  const std::vector<std::unique_ptr<Row>>& rows() const { return rows_; }

 private:
  bool quick_;
  std::vector<std::unique_ptr<Row>> rows_;
};

/// Divides the sides of all pictures: to try the program itself, the values being of no use.
struct Scale {
  int divisor = 1;
  int operator()(int side) const { return side / divisor; }
};

void add_spectral_rows(Rows& rows, Scale scaled);
void add_template_rows(Rows& rows, Scale scaled);
void add_scene_rows(Rows& rows, Scale scaled);
void add_picture_rows(Rows& rows, Scale scaled);
void add_convolution_rows(Rows& rows, Scale scaled);
void add_program_rows(Rows& rows);
void add_accuracy_rows(Rows& rows, Scale scaled);

}  // namespace glare::bench
