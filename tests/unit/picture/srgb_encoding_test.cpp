#include "glare/picture/srgb_encoding.h"

#include <gtest/gtest.h>

#include <vector>

#include "glare/color/srgb.h"

namespace glare {
namespace {

TEST(SrgbEncoding, FollowsTheCurveInVectorsAndBeyondThem) {
  std::vector<float> values;  // Of a prime number: some are left over, whatever a vector holds.
  for (int i = 0; i < 100003; ++i) values.push_back(static_cast<float>(i) / 100002);
  std::vector<float> encoded = values;
  encode_srgb(encoded);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_NEAR(encoded[i], srgb_encoded(values[i]), 3e-6) << values[i];
    ASSERT_LE(encoded[i], 1);
  }
  EXPECT_EQ(encoded.front(), 0);
}

TEST(SrgbEncoding, AValueIsTheSameAnywhereInARow) {
  for (std::size_t count = 1; count < 40; ++count) {
    std::vector<float> values(count, 0.37f);
    encode_srgb(values);
    for (const float value : values) EXPECT_EQ(value, values.front()) << count;
  }
  encode_srgb({});
}

}  // namespace
}  // namespace glare
