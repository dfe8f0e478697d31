#include "glare/io/image_file.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"

namespace glare {
namespace {

namespace fs = std::filesystem;
using std::string_literals::operator""s;

constexpr std::uint64_t kMemory = 64 << 20;

// Bytes of small files, made by hand.

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

std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = ~0u;
  for (const char character : bytes) {
    crc ^= static_cast<std::uint8_t>(character);
    for (int i = 0; i < 8; ++i) crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320u : 0);
  }
  return ~crc;
}

/// `bytes` as a zlib stream that is not compressed.
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

struct Png {
  std::uint32_t width = 2, height = 1;
  int bits = 8, color_type = 0;
  std::string pixels;      ///< Each row starts with its filter, 0.
  std::string extra = "";  ///< Chunks before the pixels.
};

std::string png(const Png& p) {
  const std::string header = big(p.width, 4) + big(p.height, 4) + static_cast<char>(p.bits) +
                             static_cast<char>(p.color_type) + "\0\0\0"s;
  return "\x89PNG\r\n\x1A\n" + png_chunk("IHDR", header) + p.extra +
         png_chunk("IDAT", stored(p.pixels)) + png_chunk("IEND", "");
}

struct TiffTag {
  int tag, type;  ///< Types: 3 is 16-bit, 4 is 32-bit.
  std::vector<std::uint32_t> values;
};

/// A TIFF file with the pixels as one strip; tags must be in order.
std::string tiff(std::vector<TiffTag> tags, const std::string& pixels, bool big_endian = false) {
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

struct Exr {
  std::vector<std::string> channels = {"Y"};  ///< In alphabetical order.
  int x = 0, y = 0, width = 2, height = 1;    ///< The data window.
  int full_width = 2, full_height = 1;        ///< The display window, from (0, 0).
  std::vector<float> rows;                    ///< Row by row, and in a row channel by channel.
  int sampling = 1, flags = 0, channel_type = 2;
  std::string extra = "";
};

std::string box(int x, int y, int width, int height) {
  return little(x, 4) + little(y, 4) + little(x + width - 1, 4) + little(y + height - 1, 4);
}

/// An uncompressed OpenEXR file of floats.
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

// Reading them.

class ImageFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "glare-image-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path put(const std::string& content, const std::string& name = "picture") const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  TransmittanceImage image_from(const std::string& content,
                                std::uint64_t max_bytes = kMemory) const {
    return read_transmittance(put(content), max_bytes);
  }
  std::vector<float> values_from(const std::string& content) const {
    const TransmittanceImage image = image_from(content);
    const auto values = image.transmittance.values();
    return {values.begin(), values.end()};
  }
  /// The message of the InputError, after checking that it starts with the file's name.
  std::string refusal(const std::string& content, std::uint64_t max_bytes = kMemory) const {
    try {
      image_from(content, max_bytes);
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), (folder_ / "picture").string());
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

using Values = std::vector<float>;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

#define EXPECT_REFUSED(content, part)                           \
  {                                                             \
    const std::string message = refusal(content);               \
    EXPECT_TRUE(contains(message, part)) << "got: " << message; \
  }

fs::path fixture(const std::string& name) {
  return fs::path(__FILE__).parent_path() / "../../data/images" / name;
}

std::string content_of(const fs::path& path) {
  const std::vector<std::byte> bytes = read_file(path, 1 << 20);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// 8-bit and 16-bit steps are exact in float after the division; a comparison for equality would
// demand the same rounding of every decoder.
constexpr float kRounding = 1e-6f;
constexpr float kHalfRounding = 5e-4f;  // Half floats near 1 are 1/2048 apart.

void expect_near(const Values& got, const Values& expected, float tolerance) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_NEAR(got[i], expected[i], tolerance) << "value " << i;
  }
}

Values ramp() {
  Values values;
  for (int i = 0; i < 15; ++i) values.push_back(static_cast<float>(17 * i) / 255);
  return values;
}

TEST_F(ImageFileTest, PngValuesAreAsStored) {
  EXPECT_EQ(values_from(png({.pixels = "\0\0\xFF"s})), (Values{0, 1}));
  expect_near(values_from(png({.pixels = "\0\x80\x40"s})), {128 / 255.f, 64 / 255.f}, kRounding);
  expect_near(values_from(png({.bits = 16, .pixels = "\0\x80\0\xFF\xFF"s})), {32768 / 65535.f, 1},
              kRounding);
  EXPECT_EQ(values_from(png({.width = 3, .bits = 1, .pixels = "\0\xA0"s})), (Values{1, 0, 1}));
  const std::string gamma = png_chunk("gAMA", big(45455, 4)) + png_chunk("sRGB", "\0"s);
  expect_near(values_from(png({.pixels = "\0\x80\x40"s, .extra = gamma})),
              {128 / 255.f, 64 / 255.f}, kRounding);
}

TEST_F(ImageFileTest, ThreeChannelsGiveTheirLuminance) {
  const std::string pixels = "\0\xFF\0\0\0\xFF\0\0\0\xFF\xFF\xFF\xFF\x33\x33\x33"s;
  expect_near(values_from(png({.width = 5, .color_type = 2, .pixels = pixels})),
              {0.2126f, 0.7152f, 0.0722f, 1, 0.2f}, kRounding);
}

TEST_F(ImageFileTest, PalettesAreLookedUp) {
  const std::string palette = png_chunk("PLTE", "\0\0\0\xFF\xFF\xFF\0\xFF\0"s);
  const std::string pixels = "\0\2\1\0"s;
  expect_near(values_from(png({.width = 3, .color_type = 3, .pixels = pixels, .extra = palette})),
              {0.7152f, 1, 0}, kRounding);
  EXPECT_REFUSED(png({.width = 3, .color_type = 3, .pixels = pixels}), "has no palette");
}

TEST_F(ImageFileTest, AlphaIsIgnoredWithAWarning) {
  const TransmittanceImage image =
      image_from(png({.color_type = 4, .pixels = "\0\x33\x80\x66\x10"s}));
  expect_near({image.transmittance(0, 0), image.transmittance(1, 0)}, {0.2f, 0.4f}, kRounding);
  ASSERT_EQ(image.warnings.size(), 1u);
  EXPECT_TRUE(contains(image.warnings[0], "alpha"));
}

TEST_F(ImageFileTest, AlphaThatAloneVariesIsTheTransmittance) {
  const TransmittanceImage image =
      image_from(png({.color_type = 6, .pixels = "\0\x10\x20\x30\x33\x10\x20\x30\xFF"s}));
  expect_near({image.transmittance(0, 0), image.transmittance(1, 0)}, {0.2f, 1}, kRounding);
  EXPECT_TRUE(image.warnings.empty());
}

TEST_F(ImageFileTest, TiffValuesAreAsStored) {
  expect_near(values_from(tiff(tiff_tags(3, 1, 8, 3), "\x00\x33\xFF"s)), {0, 0.2f, 1}, kRounding);
  EXPECT_EQ(values_from(tiff(tiff_tags(2, 1, 32, 8), floats({0.25f, 1}))), (Values{0.25f, 1}));
  EXPECT_EQ(values_from(tiff(tiff_tags(2, 1, 16, 4), "\0\0\xFF\xFF"s, true)), (Values{0, 1}));
  expect_near(values_from(tiff(tiff_tags(2, 1, 16, 4), "\x80\0\x40\0"s, true)),
              {32768 / 65535.f, 16384 / 65535.f}, kRounding);
}

TEST_F(ImageFileTest, TiffBitsWithoutTheirTagAreBits) {
  std::vector<TiffTag> tags = tiff_tags(3, 2, 1, 2);
  std::erase_if(tags, [](const TiffTag& tag) { return tag.tag == 258; });
  EXPECT_EQ(values_from(tiff(tags, "\xA0\x40")), (Values{1, 0, 1, 0, 1, 0}));
}

TEST_F(ImageFileTest, TiffInWhichZeroIsWhiteIsTurned) {
  std::vector<TiffTag> tags = tiff_tags(3, 1, 8, 3);
  tag_of(tags, 262).values = {0};
  expect_near(values_from(tiff(tags, "\x00\x33\xFF"s)), {1, 0.8f, 0}, kRounding);
  tags = tiff_tags(2, 1, 16, 4);
  tag_of(tags, 262).values = {0};
  EXPECT_EQ(values_from(tiff(tags, "\0\0\xFF\xFF"s)), (Values{1, 0}));
}

TEST_F(ImageFileTest, TiffPalettesOfBothKindsReachOne) {
  for (const std::uint32_t step : {256u, 257u}) {
    std::vector<TiffTag> tags = tiff_tags(2, 1, 8, 2);
    tag_of(tags, 262).values = {3};
    std::vector<std::uint32_t> colors(768, 0);
    for (const std::size_t channel : {0u, 256u, 512u}) {
      colors[channel + 1] = 255 * step;
      colors[channel + 2] = 51 * step;
    }
    tags.insert(tags.end() - 1, {320, 3, colors});
    expect_near(values_from(tiff(tags, "\1\2"s)), {1, 0.2f}, kRounding);
  }
}

TEST_F(ImageFileTest, TiffAlphaIsNotMultipliedIn) {
  std::vector<TiffTag> tags = tiff_tags(2, 1, 8, 4);
  tag_of(tags, 258).values = {8, 8};
  tag_of(tags, 277).values = {2};
  tag_of(tags, 339) = {338, 3, {2}};
  expect_near(values_from(tiff(tags, "\x33\x80\x66\x10"s)), {0.2f, 0.4f}, kRounding);
}

TEST_F(ImageFileTest, TiffKindsThatAreNotRead) {
  const std::pair<int, std::uint32_t> changes[] = {{259, 4}, {259, 7}, {262, 5},  {262, 6},
                                                   {277, 5}, {339, 2}, {258, 12}, {278, 0}};
  for (const auto& [tag, value] : changes) {
    std::vector<TiffTag> tags = tiff_tags(3, 1, 8, 3);
    tag_of(tags, tag).values = {value};
    EXPECT_NE(refusal(tiff(tags, "abc")), "") << tag << " " << value;
  }
}

TEST_F(ImageFileTest, ReadsPnm) {
  EXPECT_EQ(values_from("P1 3 1 101"), (Values{0, 1, 0}));
  EXPECT_EQ(values_from("P1\n3 1\n1 0\n1\n"), (Values{0, 1, 0}));
  EXPECT_EQ(values_from("P4 3 1\n\xA0"), (Values{0, 1, 0}));
  EXPECT_EQ(values_from("P2 3 1 4 1 4 0"), (Values{0.25f, 1, 0}));
  EXPECT_EQ(values_from("P5 1 2 65535\n\xFF\xFF\0\0"s), (Values{1, 0}));
  EXPECT_EQ(values_from("P5\n# a comment\n2 1 255\n\0\xFF"s), (Values{0, 1}));
  expect_near(values_from("P5 2 1 1023\n\x03\xFF\x02\x00"s), {1, 512 / 1023.f}, kRounding);
  expect_near(values_from("P5 2 1 100\n\x64\x32"), {1, 0.5f}, kRounding);
  expect_near(values_from("P6 1 1 255\n\0\xFF\0"s), {0.7152f}, kRounding);
  // The last row comes first; of the third number, only the sign counts.
  EXPECT_EQ(values_from("Pf\n1 2\n-3.5\n" + floats({0.25f, 0.75f})), (Values{0.75f, 0.25f}));
  EXPECT_EQ(values_from("Pf 1 1 1.0\n" + big(std::bit_cast<std::uint32_t>(0.5f), 4)),
            (Values{0.5f}));
}

TEST_F(ImageFileTest, RefusesBadPnm) {
  for (const std::string start : {"P5 -3 4 255\n", "P5 3 4 0\n", "P5 3 4 65536\n", "P5 0 4 255\n",
                                  "P5 x 4 255\n", "P5 3 4", "Pf 1 1 nan\n", "Pf 1 1 0\n"}) {
    EXPECT_NE(refusal(start + std::string(64, '\0')), "") << start;
  }
  EXPECT_REFUSED("P5 2000000000 2000000000 255\n", "2000000000 x 2000000000");
  EXPECT_REFUSED("P5 4 4 255\nabc", "cut short");
  EXPECT_REFUSED("P5 2 1 100\n\x65\x32", "above its maximum");
  EXPECT_REFUSED("P2 2 1 100\n1 101", "above its maximum");
  EXPECT_REFUSED("P1 3 1 12x", "0 and 1");
}

TEST_F(ImageFileTest, ReadsBmp) {
  // Rows are stored from the bottom, each filled to 4 bytes.
  const std::string rows = "\x33\x33\x33\0"s + "\xFF\xFF\xFF\0"s;
  expect_near(values_from(bmp(1, 2, 24, "", rows)), {1, 0.2f}, kRounding);
  expect_near(values_from(bmp(1, -2, 24, "", rows)), {0.2f, 1}, kRounding);
  const std::string palette = "\0\0\0\0\xFF\xFF\xFF\0"s;
  EXPECT_EQ(values_from(bmp(3, 1, 1, palette, "\xA0\0\0\0"s)), (Values{1, 0, 1}));
  expect_near(values_from(bmp(2, 1, 8, palette, "\1\0\0\0"s)), {1, 0}, kRounding);
  expect_near(values_from(bmp(1, 1, 24, "", "\xFF\0\0\0"s)), {0.0722f}, kRounding);  // Blue first.
}

TEST_F(ImageFileTest, RefusesBadBmp) {
  EXPECT_REFUSED(bmp(1000, 1000, 24, "", "abcd"), "cut short");
  EXPECT_NE(refusal(bmp(-1, 1, 24, "", "abcd")), "");
  EXPECT_NE(refusal(bmp(1, std::numeric_limits<int>::min(), 24, "", "abcd")), "");
  EXPECT_NE(refusal(bmp(1, 1, 17, "", "abcd")), "");
}

TEST_F(ImageFileTest, ReadsRadianceHdr) {
  // Exponent 128 and mantissa m: m / 256, or (m + 0.5) / 256 to some decoders.
  expect_near(values_from(hdr("-Y 1 +X 2", "\x80\x80\x80\x80\x40\x40\x40\x80")), {0.5f, 0.25f},
              0.002f);
  const std::string row = "\x02\x02\x00\x08"s + "\x88\x80\x88\x80\x88\x80\x88\x80"s;
  expect_near(values_from(hdr("-Y 1 +X 8", row)), Values(8, 0.5f), 0.002f);
}

TEST_F(ImageFileTest, RefusesBadRadianceHdr) {
  for (const std::string size :
       {"-Y 2147483647 +X 2147483647", "-Y -5 +X 5", "-Y 5 +X -5", "-Y 1 +X 99999999999999999999",
        "-Y 0 +X 0", "+X 4 +Y 4", "-Y 2 +X 40000", "-Y", "-Y  +X ", "", "-Y 3 +X 8"}) {
    EXPECT_NE(refusal(hdr(size, "abcd")), "") << size;
  }
  EXPECT_REFUSED("#?RGBE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd", "32-bit_rle_rgbe");
}

TEST_F(ImageFileTest, ExrChannelsGoByTheirNames) {
  EXPECT_EQ(values_from(exr({.rows = {0.25f, 1}})), (Values{0.25f, 1}));
  EXPECT_EQ(values_from(exr({.channels = {"mask"}, .rows = {0.25f, 1}})), (Values{0.25f, 1}));
  const Exr color{.channels = {"B", "G", "R"}, .rows = {1, 0, 0, 1, 0, 0}};
  expect_near(values_from(exr(color)), {0.0722f, 0.7152f}, kRounding);
  EXPECT_EQ(values_from(exr({.channels = {"A", "Y"}, .rows = {1, 0.5f, 0.25f, 1}})),
            (Values{0.25f, 1}));
  const TransmittanceImage extra =
      image_from(exr({.channels = {"Y", "Z"}, .rows = {0.25f, 1, 100, 200}}));
  EXPECT_EQ(extra.transmittance(0, 0), 0.25f);
  ASSERT_EQ(extra.warnings.size(), 1u);
  EXPECT_TRUE(contains(extra.warnings[0], "Z"));
  EXPECT_REFUSED(exr({.channels = {"U", "V"}, .rows = {0, 0, 0, 0}}), "has channels U, V");
}

TEST_F(ImageFileTest, ExrIsOpaqueOutsideItsDataWindow) {
  const Exr small{.x = 1,
                  .y = 1,
                  .width = 2,
                  .height = 1,
                  .full_width = 4,
                  .full_height = 3,
                  .rows = {0.5f, 1}};
  EXPECT_EQ(values_from(exr(small)), (Values{0, 0, 0, 0, 0, 0.5f, 1, 0, 0, 0, 0, 0}));
  const Exr large{.x = -1,
                  .y = -1,
                  .width = 3,
                  .height = 2,
                  .full_width = 1,
                  .full_height = 1,
                  .rows = {9, 9, 9, 9, 0.5f, 9}};
  EXPECT_EQ(values_from(exr(large)), (Values{0.5f}));
  const Exr apart{.x = 50, .y = 70, .rows = {1, 1}};
  EXPECT_EQ(values_from(exr(apart)), (Values{0, 0}));
}

TEST_F(ImageFileTest, RefusesExrThatGlareDoesNotRead) {
  EXPECT_REFUSED(exr({.rows = {0, 0}, .flags = 0x800}), "deep");
  EXPECT_REFUSED(exr({.rows = {0, 0}, .sampling = 2}), "subsampled");
  EXPECT_REFUSED(exr({.rows = {0, 0}, .channel_type = 0}), "whole numbers");
  EXPECT_REFUSED(exr({.width = 100000, .rows = {0, 0}}), "100000 x 1");
  EXPECT_REFUSED(exr({.width = 60000, .rows = {0, 0}}), "cut short");
}

TEST_F(ImageFileTest, ExrMetadataAreNotLookedAt) {
  const std::string extra = attribute("comments", "string", "abc") +
                            attribute("iccProfile", "bytes", std::string(100, '\xFF')) +
                            attribute("wrong", "int", "");
  EXPECT_EQ(values_from(exr({.rows = {0.25f, 1}, .extra = extra})), (Values{0.25f, 1}));
}

TEST_F(ImageFileTest, ReadsTheStoredFiles) {
  const auto values_of = [](const std::string& name) {
    const TransmittanceImage image = read_transmittance(fixture(name), kMemory);
    return Values(image.transmittance.values().begin(), image.transmittance.values().end());
  };
  expect_near(values_of("ramp_lzw.tif"), ramp(), kRounding);
  expect_near(values_of("ramp_deflate.tif"), ramp(), kRounding);
  for (const char* name : {"ramp_zip.exr", "ramp_tiled_piz.exr", "ramp_two_parts.exr"}) {
    expect_near(values_of(name), ramp(), kHalfRounding);
  }
  const Values grey = values_of("grey.jpg");
  for (int x = 0; x < 16; ++x) EXPECT_NEAR(grey[x], 16 * x / 255.0, 0.02) << x;  // It is lossy.
  const Values halves = values_of("black_white_progressive.jpg");
  for (int x = 0; x < 16; ++x) EXPECT_NEAR(halves[x], x < 8 ? 1 : 0, 0.02) << x;
  EXPECT_TRUE(contains(refusal(content_of(fixture("cmyk.jpg"))), "CMYK"));
}

TEST_F(ImageFileTest, ColourProfilesThatCrashDecodersAreNotLookedAt) {
  expect_near(values_from(content_of(fixture("bad_profile.jpg"))), Values(256, 128 / 255.f),
              kRounding);
  const std::string jpeg = content_of(fixture("grey.jpg"));
  const std::string exif = "Exif\0\0MM\0*\0\0\0\x08\xFF\xFF"s;
  const std::string with_exif =
      jpeg.substr(0, 2) + "\xFF\xE1" + big(exif.size() + 2, 2) + exif + jpeg.substr(2);
  EXPECT_EQ(values_from(with_exif), values_from(jpeg));
  const std::string profile = png_chunk("iCCP", "x\0\0"s + stored(std::string(200, '\xFF'))) +
                              png_chunk("eXIf", "MM\0*" + std::string(80, '\xFF'));
  EXPECT_EQ(values_from(png({.pixels = "\0\0\xFF"s, .extra = profile})), (Values{0, 1}));
}

TEST_F(ImageFileTest, TheContentTellsTheFormatNotTheName) {
  const fs::path path = put(tiff(tiff_tags(2, 1, 8, 2), "\0\xFF"s), "picture.png");
  EXPECT_EQ(read_transmittance(path, kMemory).transmittance(1, 0), 1);
}

TEST_F(ImageFileTest, SaysWhatAFileIsInstead) {
  const std::pair<std::string, std::string> cases[] = {
      {"", "the file is empty"},
      {"wavelength,power\n380,1\n", "is a text"},
      {"GIF89a......", "is a GIF"},
      {"%PDF-1.7\n", "is a PDF"},
      {"RIFF....WEBPVP8 ", "is a WebP"},
      {"\0\0\0\x18"
       "ftypheic"s,
       "is a HEIF"},
      {"\x01\x02\x03\x04\x05", "is of an unknown kind"},
      {"8BPS\0\1"s, "is a Photoshop file"},
      {"<?xml?><svg>", "is an SVG"},
      {"P", "is a text"}};
  for (const auto& [content, part] : cases) {
    EXPECT_REFUSED(content, part);
    EXPECT_REFUSED(content, content.empty() ? "" : "not an image that Glare reads (PNG, JPEG");
  }
}

TEST_F(ImageFileTest, MissingFilesAndFoldersAreInputErrors) {
  EXPECT_THROW(read_transmittance(folder_ / "missing.png", kMemory), InputError);
  EXPECT_THROW(read_transmittance(folder_, kMemory), InputError);
  EXPECT_THROW(read_transmittance("/dev/zero", kMemory), InputError);
}

TEST_F(ImageFileTest, ValuesOutsideTheRangeAreErrorsThatSayWhere) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const std::pair<float, std::string> cases[] = {
      {nan, "nan"}, {infinity, "inf"}, {-infinity, "-inf"}, {-0.25f, "-0.25"}, {1.5f, "1.5"}};
  for (const auto& [value, text] : cases) {
    const std::string message =
        refusal(exr({.height = 2, .full_height = 2, .rows = {0, 0, 0, value}}));
    EXPECT_TRUE(contains(message, "pixel (1, 1) is " + text)) << message;
  }
  EXPECT_EQ(values_from(exr({.rows = {1.0009f, 1}})), (Values{1, 1}));
  EXPECT_NE(refusal(exr({.rows = {1.002f, 1}})), "");
}

TEST_F(ImageFileTest, SizesAreCheckedBeforeAnythingIsAllocated) {
  EXPECT_REFUSED(png({.width = 2000000000, .height = 2000000000, .pixels = "\0\0"s}), "65535");
  EXPECT_REFUSED(png({.width = 65535, .height = 65535, .pixels = "\0\0"s}), "too little data");
  EXPECT_REFUSED(png({.width = 0, .pixels = "\0\0"s}), "no pixels");
  std::vector<TiffTag> tags = tiff_tags(65535, 65535, 8, 3);
  tag_of(tags, 259).values = {8};
  EXPECT_REFUSED(tiff(tags, "abc"), "too little data");
  const std::string sane = "P5 1000 1000 255\n" + std::string(1000000, '\x7F');
  EXPECT_EQ(image_from(sane, 64 << 20).transmittance.width(), 1000);
  EXPECT_THROW(image_from(sane, 5 << 20), MemoryError);
  EXPECT_THROW(image_from(sane, 1 << 10), MemoryError);
}

// Files that are cut short or altered.

/// One small file of each format.
std::vector<std::string> samples() {
  std::vector<std::string> files = {
      png({.pixels = "\0\0\xFF"s}),
      png({.width = 3, .height = 2, .bits = 16, .color_type = 6, .pixels = std::string(50, '\0')}),
      tiff(tiff_tags(2, 1, 32, 8), floats({0.25f, 1})),
      tiff(tiff_tags(3, 1, 8, 3), "abc", true),
      bmp(1, 2, 24, "", "abcdefgh"),
      hdr("-Y 1 +X 8", "\x02\x02\x00\x08"s + "\x88\x80\x88\x80\x88\x80\x88\x80"s),
      "P5 3 2 255\nabcdef",
      "P2 2 1 4 1 4 ",
      "Pf\n1 2\n-1.0\n" + floats({0.25f, 0.75f}),
      exr({.rows = {0.25f, 1}}),
      exr({.channels = {"A", "B", "G", "R"}, .rows = {1, 0, 0, 1, 0, 0, 1, 1}})};
  for (const char* name :
       {"grey.jpg", "black_white_progressive.jpg", "bad_profile.jpg", "ramp_lzw.tif",
        "ramp_deflate.tif", "ramp_zip.exr", "ramp_tiled_piz.exr", "ramp_two_parts.exr"}) {
    files.push_back(content_of(fixture(name)));
  }
  return files;
}

TEST_F(ImageFileTest, FilesCutShortAreErrors) {
  for (const std::string& file : samples()) {
    const Values whole = values_from(file);
    const std::size_t step = std::max<std::size_t>(1, file.size() / 200);
    for (std::size_t size = 0; size < file.size(); size += step) {
      // What comes after the last pixel may be missing, if the pixels are all right then.
      try {
        EXPECT_EQ(values_from(file.substr(0, size)), whole) << size << " of " << file.size();
        EXPECT_GT(size, file.size() * 9 / 20) << "read from so few bytes of " << file.size();
      } catch (const InputError&) {
      }
    }
  }
}

TEST_F(ImageFileTest, AlteredFilesAreReadOrRefused) {
  std::mt19937 random(1);
  for (const std::string& file : samples()) {
    for (int i = 0; i < 150; ++i) {
      std::string altered = file;
      const std::size_t range = i % 2 == 0 ? std::min<std::size_t>(file.size(), 64) : file.size();
      for (int changes = 1 + i % 3; changes > 0; --changes) {
        altered[random() % range] = static_cast<char>("\0\1\x7F\x80\xFF"s[random() % 5]);
      }
      try {
        image_from(altered);
      } catch (const Error&) {
      }
    }
  }
}

// Encoding.

std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST_F(ImageFileTest, Gray16ComesBackAsItWas) {
  Image<float> image(3, 2);
  const Values values = {0, 1, 0.5f, 1 / 65535.f, 32768 / 65535.f, 0.123f};
  std::copy(values.begin(), values.end(), image.values().begin());
  const std::string file = text_of(encode_png_gray16(image));
  expect_near(values_from(file), values, 0.5f / 65535 + kRounding);  // Half a step of 16 bits.
  EXPECT_EQ(file, text_of(encode_png_gray16(image)));
  image(0, 0) = std::numeric_limits<float>::quiet_NaN();
  image(1, 0) = 7;
  image(2, 0) = -7;
  const Values limited = values_from(text_of(encode_png_gray16(image)));
  EXPECT_EQ(Values(limited.begin(), limited.begin() + 3), (Values{0, 1, 0}));
  EXPECT_THROW(encode_png_gray16({}), OutputError);
}

TEST_F(ImageFileTest, Rgb8KeepsMultiplesOfItsStep) {
  Image<std::array<float, 3>> image(256, 8);
  Values expected;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 256; ++x) {
      const float value = static_cast<float>(x) / 255;
      image(x, y) = {value, value, value};
      expected.push_back(value);
    }
  }
  const std::string file = text_of(encode_png_rgb8(image));
  expect_near(values_from(file), expected, kRounding);
  EXPECT_TRUE(contains(file, "sRGB"));
  EXPECT_FALSE(contains(file, "tIME"));
  EXPECT_EQ(file, text_of(encode_png_rgb8(image)));
  EXPECT_THROW(encode_png_rgb8({}), OutputError);
}

TEST_F(ImageFileTest, Rgb8DitherKeepsTheMeanAndLimitsTheRest) {
  const float between = 100.25f / 255;
  Image<std::array<float, 3>> image(8, 8, {between, between, between});
  double sum = 0;
  for (const float value : values_from(text_of(encode_png_rgb8(image)))) sum += value;
  EXPECT_NEAR(sum / 64, between, 1e-6);  // 16 of the 64 thresholds let it through.
  const float nan = std::numeric_limits<float>::quiet_NaN();
  image = Image<std::array<float, 3>>(1, 1, {7, -7, nan});
  expect_near(values_from(text_of(encode_png_rgb8(image))), {0.2126f}, kRounding);
}

}  // namespace
}  // namespace glare
