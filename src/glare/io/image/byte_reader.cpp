#include "glare/io/image/byte_reader.h"

namespace glare::image_io {

using std::uint64_t;
using std::uint8_t;

void Reader::seek(uint64_t position) {
  require(position <= bytes_.size(), "the file is cut short");
  position_ = static_cast<std::size_t>(position);
}

std::span<const std::byte> Reader::take(uint64_t count) {
  require(count <= left(), "the file is cut short");
  const auto taken = bytes_.subspan(position_, static_cast<std::size_t>(count));
  position_ += taken.size();
  return taken;
}

uint64_t Reader::number(std::size_t size) {
  uint64_t value = 0;
  const auto taken = take(size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = order_ == std::endian::big ? i : size - 1 - i;
    value = value << 8 | std::to_integer<uint64_t>(taken[at]);
  }
  return value;
}

std::string Reader::text_z() {
  std::string text;
  while (const uint8_t character = u8()) text += static_cast<char>(character);
  return text;
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool starts_with(const Bytes& bytes, std::string_view magic) {
  return text_of(bytes).starts_with(magic);
}

void append(Bytes& to, std::span<const std::byte> bytes) {
  to.insert(to.end(), bytes.begin(), bytes.end());
}

void append(Bytes& to, std::string_view text) { append(to, std::as_bytes(std::span(text))); }

void append_number(Bytes& to, uint64_t value, std::size_t size, std::endian order) {
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = order == std::endian::little ? i : size - 1 - i;
    to.push_back(static_cast<std::byte>(value >> (8 * at)));
  }
}

}  // namespace glare::image_io
