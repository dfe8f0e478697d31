// Bytes of a file: taken with their end in view, and put together. Internal.
#pragma once

#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "glare/io/image/image_header.h"

namespace glare::image_io {

using Bytes = std::vector<std::byte>;

/// Walks through bytes in either byte order. Whatever goes past the end throws `BadImage`.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes, std::endian order = std::endian::little)
      : bytes_(bytes), order_(order) {}

  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }
  void seek(std::uint64_t position);
  std::span<const std::byte> take(std::uint64_t count);
  void skip(std::uint64_t count) { take(count); }

  /// A whole number of `size` bytes, 1 to 8.
  std::uint64_t number(std::size_t size);
  std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
  std::int64_t i32() { return static_cast<std::int32_t>(u32()); }

  /// Text up to a zero byte, which is taken too.
  std::string text_z();

 private:
  std::span<const std::byte> bytes_;
  std::endian order_;
  std::size_t position_ = 0;
};

inline std::uint8_t byte_at(const Bytes& bytes, std::size_t at) {
  require(at < bytes.size(), "the file is cut short");
  return std::to_integer<std::uint8_t>(bytes[at]);
}

std::string_view text_of(std::span<const std::byte> bytes);
bool starts_with(const Bytes& bytes, std::string_view magic);

void append(Bytes& to, std::span<const std::byte> bytes);
void append(Bytes& to, std::string_view text);
void append_number(Bytes& to, std::uint64_t value, std::size_t size, std::endian order);

/// The number that all of the word is, in digits.
template <typename T>
T number_from(std::string_view word) {
  T number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  require(error == std::errc{} && end == word.data() + word.size(), "the header is damaged");
  return number;
}

}  // namespace glare::image_io
