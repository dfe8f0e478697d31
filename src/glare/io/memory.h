// How much memory this process may take.
#pragma once

#include <cstdint>

namespace glare {

/// The memory that the machine has or, where that is less, that the process' control group allows.
std::uint64_t memory_size_bytes();

}  // namespace glare
