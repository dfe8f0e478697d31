#include "glare/base/error.h"

#include <cstdio>

namespace glare {

namespace {

std::string memory_message(std::uint64_t required_bytes, std::uint64_t allowed_bytes) {
  constexpr double mega = 1e6;
  char text[160];
  std::snprintf(text, sizeof text, "this would need %.4g MB of memory, and %.4g MB are allowed",
                static_cast<double>(required_bytes) / mega,
                static_cast<double>(allowed_bytes) / mega);
  return text;
}

}  // namespace

MemoryError::MemoryError(std::uint64_t required_bytes, std::uint64_t allowed_bytes)
    : Error(memory_message(required_bytes, allowed_bytes)),
      required_bytes_(required_bytes),
      allowed_bytes_(allowed_bytes) {}

}  // namespace glare
