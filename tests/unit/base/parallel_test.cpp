#include "glare/base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

#include "glare/base/error.h"

namespace glare {
namespace {

TEST(ParallelFor, RunsEachTaskOnce) {
  for (const int threads : {0, 1, 2, 5}) {
    std::vector<std::atomic<int>> runs(1000);
    parallel_for(1000, threads, [&](int i) { ++runs[i]; });
    EXPECT_TRUE(std::ranges::all_of(runs, [](const auto& n) { return n == 1; })) << threads;
  }
}

TEST(ParallelFor, NothingToDoIsDone) {
  parallel_for(
      0, 2, [](int) { FAIL(); }, [](double) { return false; });
}

TEST(ParallelFor, PassesATasksExceptionOn) {
  for (const int threads : {1, 2})
    EXPECT_THROW(parallel_for(100, threads,
                              [](int i) {
                                if (i == 57) throw std::out_of_range("57");
                              }),
                 std::out_of_range);
}

TEST(ParallelFor, TellsItsProgressOneCallAtATime) {
  std::vector<double> told;  // Not guarded: calls don't overlap.
  parallel_for(
      200, 2, [](int) {},
      [&](double fraction) {
        told.push_back(fraction);
        return true;
      });
  ASSERT_EQ(told.size(), 200u);
  EXPECT_EQ(*std::ranges::max_element(told), 1);
  EXPECT_GT(*std::ranges::min_element(told), 0);
}

TEST(ParallelFor, StopsWhenToldTo) {
  for (const int threads : {1, 2}) {
    std::atomic<int> done{0};
    int asked = 0;
    EXPECT_THROW(parallel_for(
                     100000, threads, [&](int) { ++done; }, [&](double) { return ++asked < 10; }),
                 Cancelled);
    EXPECT_EQ(asked, 10);  // Not asked again.
    EXPECT_LT(done, 100000);
  }
}

TEST(ParallelFor, PassesACallbacksExceptionOn) {
  const ProgressCallback fails = [](double) -> bool { throw std::domain_error("no"); };
  EXPECT_THROW(parallel_for(
                   10, 2, [](int) {}, fails),
               std::domain_error);
}

}  // namespace
}  // namespace glare
