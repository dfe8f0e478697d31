#include "glare/io/memory.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace glare {

namespace {

constexpr std::uint64_t kUnlimited = UINT64_MAX;

/// The number in a file of the cgroup file system; unlimited where there is no such file or number.
std::uint64_t limit_in(const std::string& file_name) {
  std::ifstream file(file_name);
  std::uint64_t bytes = 0;
  return file >> bytes ? bytes : kUnlimited;
}

/// The limits of the control groups that the process is in (version 2 and version 1).
std::uint64_t cgroup_limit_bytes() {
  std::uint64_t limit = std::min(limit_in("/sys/fs/cgroup/memory.max"),
                                 limit_in("/sys/fs/cgroup/memory/memory.limit_in_bytes"));
  std::ifstream membership("/proc/self/cgroup");
  for (std::string line; std::getline(membership, line);) {
    if (!line.starts_with("0::")) continue;
    for (std::string group = line.substr(3); group.size() > 1;
         group.resize(std::min(group.size() - 1, group.rfind('/'))))
      limit = std::min(limit, limit_in("/sys/fs/cgroup" + group + "/memory.max"));
  }
  return limit;
}

}  // namespace

std::uint64_t memory_size_bytes() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page_bytes = sysconf(_SC_PAGESIZE);
  const std::uint64_t physical =
      pages > 0 && page_bytes > 0
          ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_bytes)
          : kUnlimited;
  return std::min(physical, cgroup_limit_bytes());
}

}  // namespace glare
