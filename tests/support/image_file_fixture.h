// What the tests of picture files share: files in a folder of their own, read and compared.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "glare/io/image_file.h"

namespace glare::test {

using Values = std::vector<float>;

constexpr std::uint64_t kMemory = 64 << 20;

// 8-bit and 16-bit steps are exact in float after the division; a comparison for equality would
// demand the same rounding of every decoder.
constexpr float kRounding = 1e-6f;
constexpr float kHalfRounding = 5e-4f;  // Half floats near 1 are 1/2048 apart.

/// Writes pictures to a temporary folder and reads them.
class ImageFileTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  std::filesystem::path put(const std::string& content, const std::string& name = "picture") const;
  TransmittanceImage image_from(const std::string& content,
                                std::uint64_t max_bytes = kMemory) const;
  Values values_from(const std::string& content) const;
  /// The message of the InputError, after checking that it starts with the file's name; empty where
  /// there is none.
  std::string refusal(const std::string& content, std::uint64_t max_bytes = kMemory) const;

  std::filesystem::path folder_;
};

#define EXPECT_REFUSED(content, part)                           \
  {                                                             \
    const std::string message = refusal(content);               \
    EXPECT_TRUE(contains(message, part)) << "got: " << message; \
  }

bool contains(const std::string& text, const std::string& part);
std::string text_of(const std::vector<std::byte>& bytes);

void expect_near(const Values& got, const Values& expected, float tolerance);

/// The path of a stored file, of those in tests/data/images.
std::filesystem::path fixture(const std::string& name);
std::string content_of(const std::filesystem::path& path);

}  // namespace glare::test
