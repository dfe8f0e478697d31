#include "glare/convolution/glare_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <thread>
#include <vector>

#include "glare/base/error.h"
#include "support/every_target.h"
#include "support/refusals.h"

namespace glare {
namespace {

Picture random_picture(int width, int height, double decades = 0, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  Picture picture;
  picture.channels.fill(Image<float>(width, height));
  for (auto& channel : picture.channels)
    for (float& value : channel.values())
      value = static_cast<float>((0.5 + share(random)) * std::pow(10, decades * share(random)));
  return picture;
}

/// Without symmetry; its sum is `captured`, the same light in each channel but other places.
PixelKernel random_kernel(int width, int height, double captured = 0.8) {
  PixelKernel kernel;
  const Picture shares = random_picture(width, height, 3, 7);
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0;
    for (const float value : shares.channels[k].values()) sum += static_cast<double>(value);
    kernel.channels[k] = shares.channels[k];
    for (float& value : kernel.channels[k].values())
      value = static_cast<float>(captured / sum * static_cast<double>(value));
    kernel.captured[k] = captured;
    kernel.kept[k] = 1 - captured;
  }
  return kernel;
}

/// The change of channel k by the definition: a sum over the kernel at each pixel.
Image<double> exact_change(const Image<float>& picture, const PixelKernel& kernel, std::size_t k,
                           Edge edge) {
  Image<double> result(picture.width(), picture.height(), 0.0);
  const auto& shares = kernel.channels[k];
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      double sum = (kernel.kept[k] - 1) * static_cast<double>(picture(x, y));
      for (int j = 0; j < shares.height(); ++j)
        for (int i = 0; i < shares.width(); ++i) {
          const int from_x = x - (i - shares.width() / 2), from_y = y - (j - shares.height() / 2);
          const int near_x = std::clamp(from_x, 0, picture.width() - 1);
          const int near_y = std::clamp(from_y, 0, picture.height() - 1);
          if (edge == Edge::black && (near_x != from_x || near_y != from_y)) continue;
          sum += static_cast<double>(shares(i, j)) * static_cast<double>(picture(near_x, near_y));
        }
      result(x, y) = sum;
    }
  return result;
}

Picture glare_of(const Picture& picture, const PixelKernel& kernel, Edge edge,
                 std::uint64_t memory_limit_bytes = 0) {
  const GlareFilter filter(kernel, picture.width(), picture.height(),
                           {edge, 0, memory_limit_bytes});
  Picture result = picture;
  ApplyGlareOptions options;
  options.only_glare = true;
  apply_glare(result, filter, options);
  return result;
}

double largest_difference(const Picture& a, const Picture& b) {
  double result = 0;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < a.channels[k].values().size(); ++i)
      result = std::max(result, static_cast<double>(std::abs(a.channels[k].values()[i] -
                                                             b.channels[k].values()[i])));
  return result;
}

/// What the smallest blocks take.
std::uint64_t least_memory(const PixelKernel& kernel, int width, int height, Edge edge) {
  try {
    GlareFilter(kernel, width, height, {edge, 0, 1});
  } catch (const MemoryError& error) {
    return error.required_bytes();
  }
  return 0;
}

TEST(GlareFilter, BlocksGiveWhatTheWholeGives) {
  struct Case {
    int width, height, kernel_width, kernel_height;
  };
  for (const auto& [width, height, kernel_width, kernel_height] :
       {Case{300, 160, 31, 21}, Case{90, 200, 24, 40}, Case{70, 50, 139, 99}})
    for (const Edge edge : {Edge::black, Edge::extend}) {
      const Picture picture = random_picture(width, height, 4);
      const PixelKernel kernel = random_kernel(kernel_width, kernel_height);
      const Picture whole = glare_of(picture, kernel, edge);
      const std::uint64_t least = least_memory(kernel, width, height, edge);
      // Of values up to 15000, 1e-7 of each for the transforms' roundings.
      for (const std::uint64_t limit : {least, least + least / 20, least + least / 4, 2 * least})
        EXPECT_LE(largest_difference(glare_of(picture, kernel, edge, limit), whole), 0.0015)
            << width << " x " << height << ", " << limit << " of " << least;
    }
}

struct Sizes {
  int width, height, kernel_width, kernel_height;
};

const std::vector<Sizes> kSizes = {{1, 1, 1, 1},     {1, 1, 7, 5},     {2, 3, 3, 3},
                                   {16, 9, 5, 5},    {33, 20, 9, 15},  {47, 5, 31, 33},
                                   {5, 47, 33, 7},   {17, 31, 1, 9},   {64, 48, 1, 1},
                                   {30, 30, 61, 61}, {29, 31, 64, 10}, {200, 2, 41, 3}};

class GlareFilterLoops : public test::EveryTarget {};
INSTANTIATE_TEST_SUITE_P(EveryTarget, GlareFilterLoops, test::every_target(), test::target_name);

TEST_P(GlareFilterLoops, GiveTheDirectSum) {
  for (const Edge edge : {Edge::black, Edge::extend})
    for (const Sizes& s : kSizes) {
      const Picture picture = random_picture(s.width, s.height);
      const PixelKernel kernel = random_kernel(s.kernel_width, s.kernel_height);
      const Picture result = glare_of(picture, kernel, edge);
      for (std::size_t k = 0; k < 3; ++k) {
        const Image<double> exact = exact_change(picture.channels[k], kernel, k, edge);
        // Roundings of values up to the picture's 1.5, a few for each pass of the transforms.
        for (int y = 0; y < s.height; ++y)
          for (int x = 0; x < s.width; ++x)
            ASSERT_NEAR(result.channels[k](x, y), exact(x, y), 1e-6)
                << s.width << " x " << s.height << ", kernel " << s.kernel_width << " x "
                << s.kernel_height << ", at " << x << ", " << y;
      }
    }
}

TEST(GlareFilter, IsPreciseBesideBrightLights) {
  // A few lights in the dark, 1e6 to 1, and a kernel with a steep middle.
  Picture picture;
  picture.channels.fill(Image<float>(120, 90, 1.0f));
  for (auto& channel : picture.channels)
    channel(20, 30) = channel(21, 30) = channel(90, 70) = channel(100, 5) = 1e6f;
  PixelKernel kernel = random_kernel(63, 63);
  for (auto& channel : kernel.channels)
    for (int y = 0; y < 63; ++y)
      for (int x = 0; x < 63; ++x)
        channel(x, y) = static_cast<float>(0.1 / (1 + std::pow(std::hypot(x - 31, y - 31), 3)));
  const Picture result = glare_of(picture, kernel, Edge::black);
  const Image<double> exact = exact_change(picture.channels[0], kernel, 0, Edge::black);
  double added = 0, error = 0;
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x) {
      if (picture.channels[0](x, y) > 1) continue;
      added = std::max(added, exact(x, y));
      error = std::max(error, std::abs(result.channels[0](x, y) - exact(x, y)));
    }
  EXPECT_LT(error / added, 4e-7);  // A few roundings of the largest.
}

TEST(GlareFilter, ImpulseGivesTheKernelWhereItBelongs) {
  const PixelKernel kernel = random_kernel(31, 21);
  Picture picture;
  picture.channels.fill(Image<float>(60, 50));
  for (auto& channel : picture.channels) channel(20, 30) = 2;
  const Picture result = glare_of(picture, kernel, Edge::black);
  for (std::size_t k = 0; k < 3; ++k) {
    const float peak = std::ranges::max(kernel.channels[k].values());
    for (int y = 0; y < 50; ++y)
      for (int x = 0; x < 60; ++x) {
        const int i = x - 20 + 15, j = y - 30 + 10;
        const bool inside = i >= 0 && i < 31 && j >= 0 && j < 21;
        double expected = inside ? 2 * static_cast<double>(kernel.channels[k](i, j)) : 0;
        if (x == 20 && y == 30) expected += 2 * (kernel.kept[k] - 1);
        // And a rounding of the value itself, where the light is taken from.
        ASSERT_NEAR(result.channels[k](x, y), expected,
                    2e-6 * static_cast<double>(peak) + 6e-8 * std::abs(expected))
            << x << ", " << y;
      }
  }
}

TEST(GlareFilter, PictureOfOneValueStays) {
  for (const Edge edge : {Edge::black, Edge::extend}) {
    const PixelKernel kernel = random_kernel(21, 15);
    Picture picture;
    picture.channels.fill(Image<float>(70, 50, 3.0f));
    apply_glare(picture, GlareFilter(kernel, 70, 50, {edge, 0, 0}));
    const int border = edge == Edge::black ? 10 : 0;
    for (const auto& channel : picture.channels)
      for (int y = border; y < 50 - border; ++y)
        for (int x = border; x < 70 - border; ++x) ASSERT_NEAR(channel(x, y), 3, 3e-5);
    if (edge == Edge::black) {
      EXPECT_LT(picture.channels[0](0, 0), 2.5f);
    }
  }
}

TEST(GlareFilter, LightIsOnlyMoved) {
  // Black 20 pixels along the border, so that nothing leaves the picture.
  Picture picture;
  picture.channels.fill(Image<float>(80, 70));
  const Picture light = random_picture(40, 30, 5);
  double before = 0, after = 0;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      picture.channels[1](20 + x, 20 + y) = light.channels[1](x, y);
      before += static_cast<double>(light.channels[1](x, y));
    }
  apply_glare(picture, GlareFilter(random_kernel(41, 41), 80, 70));
  for (const float value : picture.channels[1].values()) after += static_cast<double>(value);
  EXPECT_NEAR(after / before, 1, 1e-6);
}

TEST(GlareFilter, StrengthAndLinearity) {
  const PixelKernel kernel = random_kernel(15, 15);
  const GlareFilter filter(kernel, 50, 40);
  const Picture picture = random_picture(50, 40, 2);
  const Picture added = glare_of(picture, kernel, Edge::black);
  for (const double strength : {0.0, 0.5, 3.0}) {
    Picture result = picture;
    ApplyGlareOptions options;
    options.strength = strength;
    options.bright.exposure_stops = 1;
    apply_glare(result, filter, options);
    for (std::size_t k = 0; k < 3; ++k)
      for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 50; ++x) {
          const double expected = 2 * (static_cast<double>(picture.channels[k](x, y)) +
                                       strength * static_cast<double>(added.channels[k](x, y)));
          ASSERT_NEAR(result.channels[k](x, y), expected, 1e-4);  // Of values up to 900.
        }
  }
}

TEST(GlareFilter, SpreadsWhatBrightPartGives) {
  const PixelKernel kernel = random_kernel(9, 11);
  Picture picture = random_picture(40, 30, 2), bright;
  const BrightPartOptions options{.exposure_stops = -1, .threshold = 10, .knee = 0.3};
  bright_part(picture, options, bright);
  const Picture expected = glare_of(bright, kernel, Edge::black);
  ApplyGlareOptions apply;
  apply.bright = options;
  apply.only_glare = true;
  apply_glare(picture, GlareFilter(kernel, 40, 30), apply);
  EXPECT_LT(largest_difference(picture, expected), 2e-5);  // Of values up to 70.
}

TEST(GlareFilter, UnusablePixelsStayAndDontSpread) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const std::uint64_t limit : {0, 400'000}) {
    const GlareFilter filter(random_kernel(21, 21), 90, 80, {Edge::extend, 0, limit});
    Picture picture = random_picture(90, 80);
    picture.channels[0](0, 0) = nan;
    picture.channels[1](89, 40) = infinity;
    picture.channels[2](45, 40) = -5;
    Picture only = picture;
    const Picture before = picture;
    const UnusablePixels found = apply_glare(picture, filter);
    EXPECT_EQ(found.nan, 1);
    EXPECT_EQ(found.infinite, 1);
    EXPECT_EQ(found.negative, 1);
    EXPECT_TRUE(std::isnan(picture.channels[0](0, 0)));
    EXPECT_EQ(picture.channels[1](0, 0), before.channels[1](0, 0));
    EXPECT_EQ(picture.channels[1](89, 40), infinity);
    EXPECT_GT(picture.channels[2](45, 40), -5);  // It gives none but gets some.
    picture.channels[0](0, 0) = picture.channels[1](89, 40) = 0;
    for (const auto& channel : picture.channels)
      for (const float value : channel.values()) ASSERT_TRUE(std::isfinite(value));
    ApplyGlareOptions options;
    options.only_glare = true;
    apply_glare(only, filter, options);
    for (const auto& channel : only.channels)
      for (const float value : channel.values()) ASSERT_TRUE(std::isfinite(value));
  }
}

TEST(GlareFilter, SumsOfTheLargestFloatsStayFinite) {
  Picture picture;
  picture.channels.fill(Image<float>(64, 64, 3e38f));
  const Picture result = glare_of(picture, random_kernel(9, 9), Edge::extend);
  for (const float value : result.channels[0].values())
    ASSERT_NEAR(value / 3e38f, 0, 1e-6);  // It stays as it is.
}

TEST(GlareFilter, IsTheSameForAnyNumberOfThreads) {
  const Picture picture = random_picture(150, 130, 4);
  for (const std::uint64_t limit : {0, 700'000}) {
    std::vector<Picture> results;
    for (const int threads : {1, 2, 3, 4}) {
      const GlareFilter filter(random_kernel(33, 21), 150, 130, {Edge::black, threads, limit});
      results.push_back(picture);
      ApplyGlareOptions options;
      options.threads = threads;
      for (int again = 0; again < 2; ++again) {  // The memory that is used again has other values.
        results.back() = picture;
        apply_glare(results.back(), filter, options);
      }
    }
    for (const Picture& result : results)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_TRUE(
            std::ranges::equal(result.channels[k].values(), results[0].channels[k].values()));
  }
}

TEST(GlareFilter, SeveralThreadsMayUseIt) {
  const GlareFilter filter(random_kernel(15, 15), 100, 90);
  const Picture picture = random_picture(100, 90);
  Picture expected = picture;
  apply_glare(expected, filter);
  std::vector<Picture> results(4, picture);
  {
    std::vector<std::jthread> threads;
    for (Picture& result : results) threads.emplace_back([&] { apply_glare(result, filter); });
  }
  for (const Picture& result : results) EXPECT_EQ(largest_difference(result, expected), 0);
}

TEST(GlareFilter, TellsItsProgressAndStops) {
  const GlareFilter filter(random_kernel(15, 15), 100, 90, {Edge::black, 1, 400'000});
  Picture picture = random_picture(100, 90);
  ApplyGlareOptions options;
  double last = 0;
  options.progress = [&](double share) {
    EXPECT_GE(share, last);
    last = share;
    return true;
  };
  apply_glare(picture, filter, options);
  EXPECT_NEAR(last, 1, 1e-12);
  options.progress = [](double share) { return share < 0.5; };
  EXPECT_THROW(apply_glare(picture, filter, options), Cancelled);
}

TEST(GlareFilter, TellsWhereMemoryIsShort) {
  try {
    GlareFilter(random_kernel(101, 101), 400, 300, {Edge::black, 0, 300'000});
    ADD_FAILURE() << "it was made";
  } catch (const MemoryError& error) {
    EXPECT_EQ(error.allowed_bytes(), 300'000);
    EXPECT_GT(error.required_bytes(), 300'000);
    // As much as it asks for is enough.
    GlareFilter(random_kernel(101, 101), 400, 300, {Edge::black, 0, error.required_bytes()});
  }
}

TEST(GlareFilter, RefusesWhatDoesNotFit) {
  const PixelKernel kernel = random_kernel(3, 3);
  test::expect_refused([&] { GlareFilter(kernel, 0, 5); }, "width");
  test::expect_refused([&] { GlareFilter(kernel, 5, 65536); }, "height");
  test::expect_refused([&] { GlareFilter(PixelKernel(), 5, 5); }, "kernel's width");
  PixelKernel uneven = kernel;
  uneven.channels[1] = Image<float>(5, 3);
  test::expect_refused([&] { GlareFilter(uneven, 5, 5); }, "one size");
  PixelKernel unknown = kernel;
  unknown.channels[2](1, 1) = std::nanf("");
  test::expect_refused([&] { GlareFilter(unknown, 5, 5); }, "finite");
  const GlareFilter filter(kernel, 5, 4);
  Picture picture = random_picture(4, 5);
  test::expect_refused([&] { apply_glare(picture, filter); }, "4 x 5");
  picture = random_picture(5, 4);
  ApplyGlareOptions options;
  options.strength = -1;
  test::expect_refused([&] { apply_glare(picture, filter, options); }, "strength");
}

}  // namespace
}  // namespace glare
