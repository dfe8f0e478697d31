// How much memory this process may take.
#pragma once

#include <cstdint>
#include <filesystem>

namespace glare {

/// The memory that the machine has or, where that is less, that the process' control group allows.
std::uint64_t memory_size_bytes();

/// What the program's commands take at most, unless told otherwise: three quarters of that.
std::uint64_t default_memory_limit_bytes();

/// The least of the limits of the control groups, of version 1 and 2, that the process is in;
/// UINT64_MAX where there is none. `root` is the folder that has `proc` and `sys` in it.
std::uint64_t control_group_limit_bytes(const std::filesystem::path& root = "/");

}  // namespace glare
