// Pictures of luminous intensities. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glare/base/image.h"
#include "glare/io/image/byte_reader.h"

namespace glare::image_io {

inline constexpr const char* kHorizontalRangeTag = "glare:horizontalRange_deg";
inline constexpr const char* kVerticalRangeTag = "glare:verticalRange_deg";

struct Intensities {
  Image<float> values;  ///< As stored; 0 or more, and finite.
  /// What an OpenEXR file tells.
  std::optional<std::array<double, 2>> horizontal_range_deg, vertical_range_deg;
  bool has_whole_numbers = false;  ///< Of 8 or 16 bits, whose largest is 1.
  std::vector<std::string> warnings;
};

bool is_picture(const Bytes& bytes);

/// The one channel of the picture. Throws `BadImage` for another number of channels or a value that
/// is negative or not finite; `MemoryError`.
Intensities intensities_of(Bytes bytes, std::uint64_t max_bytes);

}  // namespace glare::image_io
