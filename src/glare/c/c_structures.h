// Structures of options that may be older or newer than the library. Internal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>

#include "glare/c/c_errors.h"

namespace glare::c {

/// No structure is larger: a size beyond it was never set.
inline constexpr std::size_t kLargestStructure = 4096;

inline void require_structure_size(std::size_t size, const char* name) {
  if (size < sizeof(std::size_t) || size > kLargestStructure)
    throw OptionError(std::string(name) + " have a size of " + std::to_string(size) +
                      " bytes: they are first filled by their init function");
}

/// Fills the caller's structure of `size` bytes with what of `values` it has room for.
template <typename T>
void give_structure(const T& values, T* place, std::size_t size, const char* name) {
  require(place, name);
  require_structure_size(size, name);
  auto* const bytes = reinterpret_cast<unsigned char*>(place);
  const std::size_t common = std::min(size, sizeof(T));
  std::memcpy(bytes, &values, common);
  std::fill(bytes + common, bytes + size, static_cast<unsigned char>(0));
}

/// Options with their defaults, for a caller's structure.
template <typename T>
void init_options(T defaults, T* place, std::size_t size, const char* name) {
  defaults.struct_size = size;
  give_structure(defaults, place, size, name);
}

/// What the caller's options say; fields that they don't have are as in `defaults`. Throws
/// `OptionError` where they set fields that this library doesn't know.
template <typename T>
T options_of(T defaults, const T* given, const char* name) {
  if (given == nullptr) return defaults;
  const std::size_t size = given->struct_size;
  require_structure_size(size, name);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(given);
  const std::size_t common = std::min(size, sizeof(T));
  if (std::any_of(bytes + common, bytes + size, [](unsigned char b) { return b != 0; }))
    throw OptionError(std::string(name) + " set something that glare " + glare_version() +
                      " doesn't know");
  std::memcpy(&defaults, bytes, common);
  return defaults;
}

}  // namespace glare::c
