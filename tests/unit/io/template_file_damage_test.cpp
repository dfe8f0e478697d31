// Files that say they are larger than they are, of kinds that aren't read, and with blocks of scan
// lines that are shorter than they should be.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>

#include "glare/base/error.h"
#include "glare/io/template_file.h"
#include "support/scratch_folder.h"
#include "support/templates.h"

namespace glare {
namespace {

using testing::HasSubstr;

constexpr int kWidth = 40;
constexpr int kRawBytes = kWidth * 3 * 4;

template <typename Number>
std::string raw(Number number) {
  return std::string(reinterpret_cast<const char*>(&number), sizeof number);
}

/// A template of one row, so of one block of scan lines whatever the compression is.
class TemplateFileDamage : public testing::Test {
 protected:
  TemplateFileDamage() {
    GlareTemplate t;
    t.channels.fill(test::picture(kWidth, 1, [](int x, int) { return x * 0.1; }));
    t.pixel_pitch_rad = 1e-4;
    t.per_steradian = 1e5;
    t.aperture_width_mm = t.aperture_area_mm2 = 8;
    write_template(path_, t);
    bytes_ = test::file_text(path_);
  }

  std::string refusal_of(const std::string& bytes) const {
    test::set_file_text(path_, bytes);
    try {
      read_template(path_);
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), path_.string());
      return error.message();
    }
    return "(was accepted)";
  }

  /// The file with the value of an attribute, of the same size, replaced.
  std::string with_value(const std::string& name, const std::string& type,
                         const std::string& value) const {
    const std::string entry = name + '\0' + type + '\0';
    const auto place = bytes_.find(entry);
    EXPECT_NE(place, std::string::npos) << name;
    return std::string(bytes_).replace(place + entry.size() + 4, value.size(), value);
  }

  /// The file with another compression and block.
  std::string with_block(char compression, const std::string& data) const {
    const std::string bytes = with_value("compression", "compression", std::string(1, compression));
    std::size_t table = 0;
    while (bytes.compare(table, 8, raw(std::uint64_t{table + 8})) != 0) ++table;
    return bytes.substr(0, table + 8) + raw(0) + raw(static_cast<int>(data.size())) + data;
  }

  test::ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / "t.exr";
  std::string bytes_;
};

std::string window(int x_max, int y_max) { return raw(0) + raw(0) + raw(x_max) + raw(y_max); }

TEST_F(TemplateFileDamage, PixelsThatTheFileCannotHold) {
  for (const auto& [x_max, y_max] : {std::pair{29999, 29999}, {65534, 65534}, {65534, 1000}})
    EXPECT_THAT(refusal_of(with_value("dataWindow", "box2i", window(x_max, y_max))),
                HasSubstr("has too little data for its size"));
  for (const auto& [x_max, y_max] : {std::pair{70000, 0}, {0, 70000}, {-1, 0}, {INT32_MAX, -5}})
    EXPECT_THAT(refusal_of(with_value("dataWindow", "box2i", window(x_max, y_max))),
                HasSubstr("absurd size"));
  EXPECT_THAT(refusal_of(with_value("dataWindow", "box2i", window(39, 1000))),
              HasSubstr("cut short"));  // Not as many blocks.
}

TEST_F(TemplateFileDamage, AttributesThatTheFileCannotHold) {
  const std::string entry = std::string("glare:recipe") + '\0' + "string" + '\0';
  std::string bytes = bytes_;
  bytes.replace(bytes.find(entry) + entry.size(), 4, raw(0x7FFFFFFF));
  EXPECT_THAT(refusal_of(bytes), HasSubstr("cut short"));
}

TEST_F(TemplateFileDamage, MoreMemoryThanAllowed) {
  const auto read_with = [&](std::uint64_t bytes) { return read_template(path_, {bytes}); };
  EXPECT_THROW(read_with(100), MemoryError);            // Less than the file.
  EXPECT_THROW(read_with(bytes_.size()), MemoryError);  // Nothing left for the pixels.
  EXPECT_EQ(read_with(1 << 20).width(), kWidth);
  EXPECT_THROW(read_template_file(path_, {100}), MemoryError);
}

TEST_F(TemplateFileDamage, KindsThatAreNotRead) {
  for (const auto& [flag, word] :
       {std::pair{0x02, "tiled"}, {0x08, "deep"}, {0x10, "several parts"}, {0x40, "damaged"}}) {
    std::string bytes = bytes_;
    bytes[5] = static_cast<char>(bytes[5] | flag);
    EXPECT_THAT(refusal_of(bytes), HasSubstr(word));
  }
}

TEST_F(TemplateFileDamage, UncompressedBlocks) {
  EXPECT_EQ(refusal_of(with_block(0, std::string(kRawBytes, 0))), "(was accepted)");
  for (const int size : {0, 1, kRawBytes - 1, kRawBytes + 1})
    EXPECT_NE(refusal_of(with_block(0, std::string(size, 0))), "(was accepted)") << size;
}

TEST_F(TemplateFileDamage, RunLengthCodedBlocks) {
  const std::string quarter = {kRawBytes / 4 - 1, 0};  // A count less one, and the byte.
  EXPECT_EQ(refusal_of(with_block(1, quarter + quarter + quarter + quarter)), "(was accepted)");
  EXPECT_NE(refusal_of(with_block(1, quarter + quarter + quarter)), "(was accepted)");
  EXPECT_NE(refusal_of(with_block(1, quarter + std::string{-100, 0})), "(was accepted)");
}

TEST_F(TemplateFileDamage, BlocksOfAlmostNothing) {
  for (char compression = 1; compression <= 9; ++compression)
    for (const int size : {0, 1, 7}) {
      if (compression >= 8 && size > 0) continue;  // The lossy DWA can make much of a byte.
      EXPECT_NE(refusal_of(with_block(compression, std::string(size, 0))), "(was accepted)")
          << +compression << " " << size;
    }
}

}  // namespace
}  // namespace glare
