#include "glare/base/aligned_memory.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "glare/base/image.h"

namespace glare {
namespace {

constexpr std::size_t kCacheLine = 64, kLargePage = std::size_t{2} << 20;

std::uintptr_t address(const void* memory) { return reinterpret_cast<std::uintptr_t>(memory); }

TEST(AlignedMemory, IsAlignedToACacheLine) {
  for (const std::size_t bytes :
       {std::size_t{1}, std::size_t{63}, std::size_t{4097}, kLargePage - 1})
    for (int i = 0; i < 3; ++i) {
      void* const memory = allocate_aligned(bytes);
      EXPECT_EQ(address(memory) % kCacheLine, 0u) << bytes;
      std::memset(memory, 1, bytes);
      free_aligned(memory, bytes);
    }
}

TEST(AlignedMemory, LargeOnesAreAlignedToLargePages) {
  for (const std::size_t bytes :
       {kLargePage, kLargePage + 1, 2 * kLargePage - 1, 3 * kLargePage + 4096}) {
    void* const memory = allocate_aligned(bytes);
    EXPECT_EQ(address(memory) % kLargePage, 0u) << bytes;
    std::memset(memory, 1, bytes);  // All of it can be used.
    EXPECT_EQ(static_cast<const char*>(memory)[bytes - 1], 1);
    free_aligned(memory, bytes);
  }
}

TEST(AlignedMemory, ServesContainers) {
  for (const std::size_t count : {std::size_t{3}, kLargePage}) {
    std::vector<float, AlignedAllocator<float>> values(count, 2.5f);
    EXPECT_EQ(address(values.data()) % kCacheLine, 0u);
    values.push_back(1);
    EXPECT_EQ(values.front(), 2.5f);
    EXPECT_EQ(values[count - 1], 2.5f);
    EXPECT_EQ(values.back(), 1);
  }
}

TEST(AlignedMemory, TooManyValuesAreRefused) {
  AlignedAllocator<double> allocator;
  // Times 8, it would be 8 but for the overflow.
  EXPECT_THROW(allocator.allocate(std::numeric_limits<std::size_t>::max() / 8 + 2),
               std::bad_array_new_length);
}

TEST(AlignedMemory, APictureThatIsNotInitialisedHasItsSize) {
  struct Case {
    int width, height;
  };
  for (const Case c : {Case{3, 2}, {1500, 1001}, {0, 5}, {5, 0}}) {
    auto image = Image<float>::uninitialized(c.width, c.height);
    EXPECT_EQ(image.width(), c.width);
    EXPECT_EQ(image.height(), c.height);
    ASSERT_EQ(image.values().size(), static_cast<std::size_t>(c.width) * c.height);
    for (float& value : image.values()) value = 4;  // All of it can be used.
    for (int y = 0; y < c.height; ++y)
      EXPECT_EQ(image.row(y).size(), static_cast<std::size_t>(c.width));
  }
}

}  // namespace
}  // namespace glare
