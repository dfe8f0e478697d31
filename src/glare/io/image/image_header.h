// What a picture's file says of itself, and what that takes: sizes are bounded before anything is
// allocated for them. Internal.
#pragma once

#include <cstdint>
#include <stdexcept>

namespace glare::image_io {

constexpr std::uint64_t kMaxSide = 65535;
constexpr std::uint64_t kDeflateRatio = 1032;  // 258 bytes from 2 bits.

/// What is wrong with the content of a file, as the rest of a sentence about it or as a sentence.
/// It becomes an `InputError` with the file's name.
struct BadImage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws `BadImage` with the message unless the condition holds.
inline void require(bool condition, const char* message) {
  if (!condition) throw BadImage(message);
}

/// What the file's own header says, and what it takes.
struct Header {
  std::uint64_t width = 0;  ///< Of the picture that the decoder returns.
  std::uint64_t height = 0;
  std::uint64_t channels = 0;       ///< At most so many are returned.
  std::uint64_t least_bytes = 0;    ///< No file of this kind with that many pixels is smaller.
  std::uint64_t decoder_bytes = 0;  ///< Memory that the decoder may need for itself.
  std::uint64_t whole_pixels = 0;   ///< Of the whole picture, where that isn't what is stored.
  bool zero_is_white = false;       ///< The first channel is 1 minus what is stored.
  bool linear_light = false;        ///< Floats, which are not encoded for a display.
};

/// Requires sides from 1 to `kMaxSide`: products of two of them and a small factor fit 64 bits.
void require_sides(std::uint64_t width, std::uint64_t height);

/// Requires that a file of `file_bytes` can hold the picture. Throws `MemoryError` where reading it
/// would take more than `max_bytes`; `result_channels` floats a pixel are made of it in the end.
void require_fits(const Header& header, std::uint64_t file_bytes, std::uint64_t max_bytes,
                  std::uint64_t result_channels);

/// The quotient, rounded up.
constexpr std::uint64_t divided_up(std::uint64_t value, std::uint64_t by) {
  return value / by + (value % by != 0);
}

}  // namespace glare::image_io
