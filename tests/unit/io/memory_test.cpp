#include "glare/io/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/scratch_folder.h"

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

TEST(Memory, ThreeQuartersAreTaken) {
  EXPECT_EQ(default_memory_limit_bytes(), memory_size_bytes() / 4 * 3);
}

/// A folder with a `proc` and a `sys` of its own.
class ControlGroups : public testing::Test {
 protected:
  void put(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  std::uint64_t limit() const { return control_group_limit_bytes(folder_ / "."); }

  test::ScratchFolder folder_;
};

TEST_F(ControlGroups, NoneLimitsNothing) {
  EXPECT_EQ(limit(), UINT64_MAX);
  put("proc/self/cgroup", "0::/\n");
  put("sys/fs/cgroup/memory.max", "max\n");
  EXPECT_EQ(limit(), UINT64_MAX);
}

TEST_F(ControlGroups, OfVersion2) {
  put("proc/self/cgroup", "0::/outer/inner\n");
  put("sys/fs/cgroup/outer/inner/memory.max", "max\n");
  EXPECT_EQ(limit(), UINT64_MAX);
  put("sys/fs/cgroup/outer/memory.max", "3000000\n");  // Binds those within it.
  EXPECT_EQ(limit(), 3'000'000u);
  put("sys/fs/cgroup/outer/inner/memory.max", "2000000\n");
  EXPECT_EQ(limit(), 2'000'000u);
  put("sys/fs/cgroup/other/memory.max", "5\n");
  EXPECT_EQ(limit(), 2'000'000u);
  put("sys/fs/cgroup/memory.max", "1000000\n");  // A container's.
  EXPECT_EQ(limit(), 1'000'000u);
}

TEST_F(ControlGroups, OfVersion1) {
  put("proc/self/cgroup", "7:cpu,cpuacct:/busy\n4:hugetlb,memory:/outer/inner\n0::/none\n");
  put("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");  // Its "none".
  put("sys/fs/cgroup/memory/busy/memory.limit_in_bytes", "5\n");
  EXPECT_EQ(limit(), 9223372036854771712u);
  put("sys/fs/cgroup/memory/outer/inner/memory.limit_in_bytes", "4000000\n");
  EXPECT_EQ(limit(), 4'000'000u);
  put("sys/fs/cgroup/memory/outer/memory.limit_in_bytes", "3000000\n");
  EXPECT_EQ(limit(), 3'000'000u);
}

TEST_F(ControlGroups, DamagedFilesLimitNothing) {
  put("proc/self/cgroup", "\nnonsense\n4:memory\n0::\n0::/../../outer\n");
  put("sys/fs/cgroup/memory.max", "many\n");
  EXPECT_EQ(limit(), UINT64_MAX);
}

}  // namespace
}  // namespace glare
