// What the tests of vectorised loops share.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace glare::test {

/// Each test is run with every instruction set that was compiled and that the machine has, down to
/// the one that any machine has. All meet the same plain loops in double, and so one another.
class EveryTarget : public testing::TestWithParam<std::int64_t> {
 protected:
  void SetUp() override { choose(GetParam()); }
  void TearDown() override { choose(0); }

 private:
  static void choose(std::int64_t targets) {  // 0: all of them.
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

inline auto every_target() { return testing::ValuesIn(hwy::SupportedAndGeneratedTargets()); }

inline std::string target_name(const testing::TestParamInfo<std::int64_t>& test) {
  return hwy::TargetName(test.param);
}

/// Sums of so many products of values between -1 and 1, in single precision: a rounding each.
inline double rounding(std::size_t products) { return 6e-8 * static_cast<double>(products + 2); }

/// Between -1 and 1; others with every call.
inline std::vector<float> random_values(std::size_t count) {
  static std::mt19937 random(1);
  std::uniform_real_distribution<float> value(-1, 1);
  std::vector<float> values(count);
  for (float& v : values) v = value(random);
  return values;
}

}  // namespace glare::test
