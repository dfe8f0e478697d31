#include "glare/io/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

namespace glare {
namespace {

TEST(Memory, IsTheMachinesAtMost) {
  const std::uint64_t bytes = memory_size_bytes();
  EXPECT_GT(bytes, 1'000'000u);
  EXPECT_LE(bytes, static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                       static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)));
}

TEST(Memory, IsTheControlGroupsAtMost) {
  std::uint64_t limit = 0;
  for (const std::string name :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
    if (std::ifstream(name) >> limit) {
      EXPECT_LE(memory_size_bytes(), limit) << name;
    }
}

}  // namespace
}  // namespace glare
