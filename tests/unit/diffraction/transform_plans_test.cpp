#include "glare/diffraction/transform_plans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <thread>
#include <vector>

#include "glare/diffraction/far_field.h"
#include "support/templates.h"

namespace glare {
namespace {

struct TransformPlans : testing::Test {
  TransformPlans() { forget_transform_plans(); }
  ~TransformPlans() override { forget_transform_plans(); }
};

constexpr int kSide = 200;

FarFieldRequest request() {
  FarFieldRequest result;
  result.max_frequency_x_per_mm = result.max_frequency_y_per_mm = 12;
  return result;
}

FarField uneven_field() {
  const auto value = [](int x, int y) { return ((7 * x + 5 * y * y) % 11) / 10.; };
  return far_field({test::picture(kSide, kSide, value), 8}, request());
}

std::array<int, 2> lengths() {
  return far_field_transform_lengths(kSide, kSide, 8.0 / kSide, request());
}

void expect_within_rounding(const FarField& a, const FarField& b) {
  const auto x = a.intensity_mm2.values(), y = b.intensity_mm2.values();
  ASSERT_EQ(x.size(), y.size());
  const float peak = std::ranges::max(x);
  for (std::size_t i = 0; i < x.size(); ++i)
    ASSERT_NEAR(x[i], y[i], 1e-6f * peak);  // Single precision.
}

TEST_F(TransformPlans, MeasuredOnesGiveTheSameFarFieldWithinRounding) {
  const FarField estimated = uneven_field();
  measure_transforms(lengths());
  expect_within_rounding(uneven_field(), estimated);
}

TEST_F(TransformPlans, ForgottenOnesGiveTheSameBytesAgain) {
  const FarField before = uneven_field();
  measure_transforms(lengths());
  forget_transform_plans();
  const FarField after = uneven_field();
  EXPECT_TRUE(std::ranges::equal(before.intensity_mm2.values(), after.intensity_mm2.values()));
}

TEST_F(TransformPlans, GivenOnGiveTheSameBytes) {
  measure_transforms(lengths());
  const FarField measured = uneven_field();
  const std::string text = transform_plans_text();
  forget_transform_plans();
  ASSERT_TRUE(adopt_transform_plans(text));
  EXPECT_TRUE(
      std::ranges::equal(measured.intensity_mm2.values(), uneven_field().intensity_mm2.values()));
}

TEST_F(TransformPlans, AreThoseOfTheLengthsThatTheFarFieldHas) {
  uneven_field();
  const std::string estimated = transform_plans_text();
  measure_transforms(lengths());
  EXPECT_NE(transform_plans_text(), estimated);
  const std::size_t measured = transform_plans_text().size();
  uneven_field();
  EXPECT_EQ(transform_plans_text().size(), measured);  // It has looked for no other plan.
}

TEST_F(TransformPlans, OfAnotherLibraryAreNotTaken) {
  EXPECT_FALSE(adopt_transform_plans("(fftw-3.1.0 fftwf_wisdom #x0 #x0 #x0 #x0\n)\n"));
  EXPECT_FALSE(transform_library().empty());
}

TEST_F(TransformPlans, AreMeasuredWhileOthersTransform) {
  const FarField expected = uneven_field();
  std::thread measuring([] { measure_transforms(std::vector{48, 60, 100, 210, 256}); });
  for (int i = 0; i < 20; ++i) expect_within_rounding(uneven_field(), expected);
  measuring.join();
}

}  // namespace
}  // namespace glare
