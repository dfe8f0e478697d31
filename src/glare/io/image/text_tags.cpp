#include "glare/io/image/text_tags.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>
#include <system_error>

#include "glare/io/image/crc32.h"

namespace glare::image_io {

namespace {

constexpr std::string_view kPngMagic = "\x89PNG\r\n\x1a\n", kExrMagic = "\x76\x2f\x31\x01";

std::optional<double> number_in(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::optional<double> png_number(const Bytes& file, const std::string& name) {
  Reader reader(file, std::endian::big);
  reader.skip(kPngMagic.size());
  while (reader.left() > 0) {
    const std::uint32_t size = reader.u32();
    const std::string_view type = text_of(reader.take(4));
    if (type == "IDAT") break;
    const std::string_view data = text_of(reader.take(size));
    if (type == "tEXt" && data.substr(0, data.find('\0')) == name && data.size() > name.size())
      return number_in(data.substr(name.size() + 1));
    reader.skip(4);
  }
  return std::nullopt;
}

/// The content of the first header's attribute of that name and type.
std::optional<Reader> exr_attribute(const Bytes& file, const std::string& name,
                                    const std::string& type) {
  if (!starts_with(file, kExrMagic)) return std::nullopt;
  Reader reader(file);
  reader.skip(8);
  for (std::string found = reader.text_z(); !found.empty(); found = reader.text_z()) {
    const std::string found_type = reader.text_z();
    const auto content = reader.take(reader.u32());
    if (found == name && found_type == type) return Reader(content);
  }
  return std::nullopt;
}

/// The same of a damaged file: nothing.
std::optional<Reader> exr_attribute_if_any(const Bytes& file, const std::string& name,
                                           const std::string& type) try {
  return exr_attribute(file, name, type);
} catch (const BadImage&) {
  return std::nullopt;
}

std::optional<double> exr_number(const Bytes& file, const std::string& name) {
  auto content = exr_attribute(file, name, "float");
  if (!content || content->left() != sizeof(float)) return std::nullopt;
  return std::bit_cast<float>(content->u32());
}

}  // namespace

std::optional<double> positive_tag(const Bytes& file, const std::string& name) try {
  std::optional<double> number;
  if (starts_with(file, kPngMagic)) number = png_number(file, name);
  if (starts_with(file, kExrMagic)) number = exr_number(file, name);
  return number && std::isfinite(*number) && *number > 0 ? number : std::nullopt;
} catch (const BadImage&) {
  return std::nullopt;
}

std::optional<std::string> exr_text(const Bytes& file, const std::string& name) {
  auto content = exr_attribute_if_any(file, name, "string");
  if (!content) return std::nullopt;
  return std::string(text_of(content->take(content->left())));
}

std::optional<std::array<float, 8>> exr_chromaticities(const Bytes& file) {
  auto content = exr_attribute_if_any(file, "chromaticities", "chromaticities");
  std::array<float, 8> numbers;
  if (!content || content->left() != sizeof numbers) return std::nullopt;
  for (float& number : numbers) number = std::bit_cast<float>(content->u32());
  return numbers;
}

Bytes png_with_text(const Bytes& png, const std::string& name, const std::string& text) {
  constexpr std::size_t kHeaderEnd = 8 + 4 + 4 + 13 + 4;  // Magic, and the chunk IHDR.
  Bytes chunk;
  append(chunk, "tEXt");
  append(chunk, name);
  append(chunk, std::string_view("", 1));
  append(chunk, text);
  const std::span<const std::byte> all(png);
  Bytes result;
  append(result, all.first(kHeaderEnd));
  append_number(result, chunk.size() - 4, 4, std::endian::big);
  append(result, chunk);
  append_number(result, crc32(chunk), 4, std::endian::big);
  append(result, all.subspan(kHeaderEnd));
  return result;
}

}  // namespace glare::image_io
