#include "glare/io/radiance/rgbe_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace glare::radiance_io {

using image_io::Bytes;

namespace {

using Rgbe = std::array<std::uint8_t, 4>;

constexpr int kExponentBias = 128;
constexpr float kLargest = 255.0f / 256 * 0x1p127f;

float limited_value(float value, bool& limited) {
  if (value >= 0 && value <= kLargest) return value;
  if (value == 0) return 0;
  limited = true;
  return value > kLargest ? kLargest : 0;
}

Rgbe rgbe_of(const std::array<float, 3>& rgb) {
  const float largest = *std::ranges::max_element(rgb);
  int exponent = 0;
  std::frexp(largest, &exponent);
  if (largest == 0 || exponent <= -kExponentBias) return {};
  Rgbe code;
  for (std::size_t k = 0; k < rgb.size(); ++k)
    code[k] = static_cast<std::uint8_t>(std::ldexp(rgb[k], 8 - exponent));
  code[3] = static_cast<std::uint8_t>(exponent + kExponentBias);
  return code;
}

std::vector<Rgbe> coded_row(const Picture& picture, int row, std::uint64_t& limited) {
  std::vector<Rgbe> codes;
  codes.reserve(static_cast<std::size_t>(picture.width()));
  for (int column = 0; column < picture.width(); ++column) {
    bool is_limited = false;
    std::array<float, 3> rgb;
    for (std::size_t k = 0; k < rgb.size(); ++k)
      rgb[k] = limited_value(picture.channels[k](column, row), is_limited);
    codes.push_back(rgbe_of(rgb));
    limited += is_limited;
  }
  return codes;
}

void append_byte(Bytes& to, std::size_t value) { to.push_back(static_cast<std::byte>(value)); }

std::size_t run_length(std::span<const Rgbe> row, std::size_t at, std::size_t component) {
  constexpr std::size_t longest = 127;
  std::size_t length = 1;
  while (at + length < row.size() && length < longest &&
         row[at + length][component] == row[at][component])
    ++length;
  return length;
}

/// Runs of four or more equal bytes: 128 + their number, and the byte. Others: their number, at
/// most 128, and the bytes.
void append_runs(Bytes& to, std::span<const Rgbe> row, std::size_t component) {
  constexpr std::size_t shortest_run = 4, most_others = 128;
  for (std::size_t at = 0; at < row.size();) {
    if (const std::size_t run = run_length(row, at, component); run >= shortest_run) {
      append_byte(to, 128 + run);
      append_byte(to, row[at][component]);
      at += run;
      continue;
    }
    std::size_t end = at;
    while (end < row.size() && end - at < most_others &&
           run_length(row, end, component) < shortest_run)
      ++end;
    append_byte(to, end - at);
    for (; at < end; ++at) append_byte(to, row[at][component]);
  }
}

void append_row(Bytes& to, std::span<const Rgbe> row) {
  const bool in_runs = row.size() >= 8 && row.size() <= 32767;  // What the rows' mark can tell.
  if (!in_runs) {
    for (const Rgbe& code : row)
      for (const std::uint8_t byte : code) append_byte(to, byte);
    return;
  }
  for (const std::size_t byte : {std::size_t{2}, std::size_t{2}, row.size() >> 8, row.size() & 255})
    append_byte(to, byte);
  for (std::size_t component = 0; component < 4; ++component) append_runs(to, row, component);
}

}  // namespace

Bytes rgbe_rows(const Picture& picture, std::uint64_t& limited) {
  Bytes bytes;
  for (int row = 0; row < picture.height(); ++row)
    append_row(bytes, coded_row(picture, row, limited));
  return bytes;
}

}  // namespace glare::radiance_io
