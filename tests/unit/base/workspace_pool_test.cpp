#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <vector>

#include "glare/base/parallel.h"

namespace glare {
namespace {

struct Workspace {
  Workspace() { ++made; }
  static inline std::atomic<int> made{0};
  std::atomic<int> users{0};
  std::vector<int> memory;
};

TEST(WorkspacePool, GivesEachTakerItsOwn) {
  WorkspacePool<Workspace> pool;
  const auto a = pool.take(), b = pool.take(), c = pool.take();
  EXPECT_EQ((std::set<Workspace*>{a.get(), b.get(), c.get()}.size()), 3u);
}

TEST(WorkspacePool, GivesWhatCameBackAgain) {
  WorkspacePool<Workspace> pool;
  const Workspace* first = nullptr;
  {
    const auto taken = pool.take();
    taken->memory.assign(10, 7);
    first = taken.get();
  }
  const auto again = pool.take();
  EXPECT_EQ(again.get(), first);
  EXPECT_EQ(again->memory, std::vector<int>(10, 7));
}

TEST(WorkspacePool, TasksAtTheSameTimeShareNone) {
  constexpr int kThreads = 4;
  WorkspacePool<Workspace> pool;
  std::atomic<int> shared{0}, done{0};
  Workspace::made = 0;
  parallel_for(20000, kThreads, [&](int) {
    const auto taken = pool.take();
    if (++taken->users != 1) ++shared;
    taken->memory.assign(100, 1);  // Long enough for others to come in.
    --taken->users;
    ++done;
  });
  EXPECT_EQ(done, 20000);
  EXPECT_EQ(shared, 0);
  EXPECT_GE(Workspace::made, 1);
  EXPECT_LE(Workspace::made, kThreads);
}

}  // namespace
}  // namespace glare
