#include "support/image_bytes.h"

#include <algorithm>
#include <bit>

namespace glare::test {

using std::string_literals::operator""s;

namespace {

std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = ~0u;
  for (const char character : bytes) {
    crc ^= static_cast<std::uint8_t>(character);
    for (int i = 0; i < 8; ++i) crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320u : 0);
  }
  return ~crc;
}

std::string box(int x, int y, int width, int height) {
  return little(x, 4) + little(y, 4) + little(x + width - 1, 4) + little(y + height - 1, 4);
}

}  // namespace

std::string little(std::uint64_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

std::string big(std::uint64_t value, int size) {
  const std::string bytes = little(value, size);
  return {bytes.rbegin(), bytes.rend()};
}

std::string float_bytes(float value) { return little(std::bit_cast<std::uint32_t>(value), 4); }

std::string floats(const std::vector<float>& values) {
  std::string bytes;
  for (const float value : values) bytes += float_bytes(value);
  return bytes;
}

std::string stored(const std::string& bytes) {
  std::uint32_t a = 1, b = 0;
  for (const char character : bytes) {
    a = (a + static_cast<std::uint8_t>(character)) % 65521;
    b = (b + a) % 65521;
  }
  return "\x78\x01\x01"s + little(bytes.size(), 2) + little(~bytes.size(), 2) + bytes +
         big(b << 16 | a, 4);
}

std::string png_chunk(const std::string& type, const std::string& content) {
  return big(content.size(), 4) + type + content + big(crc32(type + content), 4);
}

std::string png(const Png& p) {
  const std::string header = big(p.width, 4) + big(p.height, 4) + static_cast<char>(p.bits) +
                             static_cast<char>(p.color_type) + "\0\0\0"s;
  return "\x89PNG\r\n\x1A\n" + png_chunk("IHDR", header) + p.extra +
         png_chunk("IDAT", stored(p.pixels)) + png_chunk("IEND", "");
}

std::string tiff(std::vector<TiffTag> tags, const std::string& pixels, bool big_endian) {
  const auto number = [&](std::uint64_t v, int size) {
    return big_endian ? big(v, size) : little(v, size);
  };
  std::string data = pixels + (pixels.size() % 2 != 0 ? "\0"s : ""s);
  std::string entries;
  for (const TiffTag& tag : tags) {
    std::string values;
    for (const std::uint32_t v : tag.values) values += number(v, tag.type == 3 ? 2 : 4);
    if (values.size() > 4) {
      const std::string content = values;
      values = number(8 + data.size(), 4);
      data += content;
    }
    values.resize(4);
    entries += number(tag.tag, 2) + number(tag.type, 2) + number(tag.values.size(), 4) + values;
  }
  return (big_endian ? "MM\0*"s : "II*\0"s) + number(8 + data.size(), 4) + data +
         number(tags.size(), 2) + entries + number(0, 4);
}

std::vector<TiffTag> tiff_tags(std::uint32_t width, std::uint32_t height, std::uint32_t bits,
                               std::uint32_t size) {
  return {{256, 3, {width}}, {257, 3, {height}},
          {258, 3, {bits}},  {259, 3, {1}},
          {262, 3, {1}},     {273, 4, {8}},
          {277, 3, {1}},     {278, 3, {height}},
          {279, 4, {size}},  {339, 3, {bits == 32 ? 3u : 1u}}};
}

TiffTag& tag_of(std::vector<TiffTag>& tags, int tag) {
  return *std::find_if(tags.begin(), tags.end(), [&](const TiffTag& t) { return t.tag == tag; });
}

std::string bmp(int width, int height, int bits, const std::string& palette,
                const std::string& rows) {
  const std::size_t start = 54 + palette.size();
  return "BM" + little(start + rows.size(), 4) + little(0, 4) + little(start, 4) + little(40, 4) +
         little(width, 4) + little(height, 4) + little(1, 2) + little(bits, 2) + little(0, 4) +
         little(rows.size(), 4) + little(0, 8) + little(palette.size() / 4, 4) + little(0, 4) +
         palette + rows;
}

std::string hdr(const std::string& size, const std::string& pixels) {
  return "#?RADIANCE\nEXPOSURE=2\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + pixels;
}

std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
  return name + "\0"s + type + "\0"s + little(value.size(), 4) + value;
}

std::string exr(const Exr& e) {
  std::string channels;
  for (const std::string& name : e.channels) {
    channels += name + "\0"s + little(e.channel_type, 4) + little(0, 4) + little(e.sampling, 4) +
                little(e.sampling, 4);
  }
  std::string file = "v/1\x01" + little(2 | e.flags, 4) +
                     attribute("channels", "chlist", channels + "\0"s) +
                     attribute("compression", "compression", "\0"s) +
                     attribute("dataWindow", "box2i", box(e.x, e.y, e.width, e.height)) +
                     attribute("displayWindow", "box2i", box(0, 0, e.full_width, e.full_height)) +
                     e.extra + attribute("lineOrder", "lineOrder", "\0"s) +
                     attribute("pixelAspectRatio", "float", float_bytes(1)) +
                     attribute("screenWindowCenter", "v2f", little(0, 8)) +
                     attribute("screenWindowWidth", "float", float_bytes(1)) + "\0"s;
  const std::size_t row_bytes = 4 * e.channels.size() * static_cast<std::size_t>(e.width);
  const std::size_t start = file.size() + 8 * static_cast<std::size_t>(e.height);
  const std::string pixels = floats(e.rows);
  std::string chunks;
  for (int i = 0; i < e.height; ++i) {
    file += little(start + chunks.size(), 8);
    chunks += little(e.y + i, 4) + little(row_bytes, 4) + pixels.substr(row_bytes * i, row_bytes);
  }
  return file + chunks;
}

}  // namespace glare::test
