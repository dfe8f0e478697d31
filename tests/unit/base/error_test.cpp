#include "glare/base/error.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace glare {
namespace {

TEST(Error, OneFamily) {
  static_assert(std::is_base_of_v<std::runtime_error, Error>);
  static_assert(std::is_base_of_v<Error, InputError> && std::is_base_of_v<Error, OptionError> &&
                std::is_base_of_v<Error, OutputError> && std::is_base_of_v<Error, MemoryError> &&
                std::is_base_of_v<Error, Cancelled>);
  EXPECT_STREQ(Cancelled().what(), "cancelled");
}

TEST(Error, APlaceLeadsTheMessage) {
  const InputError input("lamp.csv:12", "has no number");
  EXPECT_STREQ(input.what(), "lamp.csv:12: has no number");
  EXPECT_EQ(input.place(), "lamp.csv:12");
  EXPECT_STREQ(InputError("", "has no number").what(), "has no number");
  const OutputError output("out.exr", "the disk is full");
  EXPECT_STREQ(output.what(), "out.exr: the disk is full");
  EXPECT_EQ(output.place(), "out.exr");
}

TEST(Error, MemoryIsToldInMegabytes) {
  const MemoryError error(1'234'000'000, 500'000'000);
  EXPECT_STREQ(error.what(), "this would need 1234 MB of memory, and 500 MB are allowed");
  EXPECT_EQ(error.required_bytes(), 1'234'000'000u);
  EXPECT_EQ(error.allowed_bytes(), 500'000'000u);
}

}  // namespace
}  // namespace glare
