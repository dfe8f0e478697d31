#include "support/image_file_fixture.h"

#include <stdlib.h>

#include <fstream>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"

namespace glare::test {

namespace fs = std::filesystem;

void ImageFileTest::SetUp() {
  std::string pattern = (fs::temp_directory_path() / "glare-image-XXXXXX").string();
  ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
  folder_ = pattern;
}

void ImageFileTest::TearDown() { fs::remove_all(folder_); }

fs::path ImageFileTest::put(const std::string& content, const std::string& name) const {
  std::ofstream(folder_ / name, std::ios::binary) << content;
  return folder_ / name;
}

TransmittanceImage ImageFileTest::image_from(const std::string& content,
                                             std::uint64_t max_bytes) const {
  return read_transmittance(put(content), max_bytes);
}

Values ImageFileTest::values_from(const std::string& content) const {
  const TransmittanceImage image = image_from(content);
  const auto values = image.transmittance.values();
  return {values.begin(), values.end()};
}

std::string ImageFileTest::refusal(const std::string& content, std::uint64_t max_bytes) const {
  try {
    image_from(content, max_bytes);
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), (folder_ / "picture").string());
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void expect_near(const Values& got, const Values& expected, float tolerance) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_NEAR(got[i], expected[i], tolerance) << "value " << i;
  }
}

fs::path fixture(const std::string& name) {
  return fs::path(GLARE_SOURCE_DIR) / "tests/data/images" / name;
}

std::string content_of(const fs::path& path) {
  const std::vector<std::byte> bytes = read_file(path, 1 << 20);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace glare::test
