#include "glare/glare_c.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "glare/convolution/glare_filter.h"
#include "glare/spectrum/lamps.h"
#include "glare/template/make_template.h"
#include "support/templates.h"

namespace glare {
namespace {

constexpr int kWidth = 24, kHeight = 18;

/// A template of the small pupil through either interface.
class CInterface : public testing::Test {
 protected:
  void SetUp() override {
    const Image<float>& pupil = test::small_pupil().transmittance;
    ASSERT_EQ(glare_template_options_init(&options_, sizeof options_, &error_), GLARE_OK);
    options_.width = 33;
    options_.height = 21;
    options_.field_of_view_deg = 0.3;
    ASSERT_EQ(glare_lamp_find("A", &lamp_, &error_), GLARE_OK);
    ASSERT_EQ(glare_template_make_aperture(pupil.values().data(), pupil.width(), pupil.height(),
                                           test::small_pupil().width_mm, lamp_, &options_, &made_,
                                           &error_),
              GLARE_OK)
        << error_.message;
    ASSERT_EQ(glare_filter_options_init(&frames_, sizeof frames_, &error_), GLARE_OK);
    frames_.width = kWidth;
    frames_.height = kHeight;
    frames_.pixel_deg = 0.011;
  }
  void TearDown() override {
    glare_template_free(made_);
    glare_lamp_free(lamp_);
  }

  static GlareTemplate expected() {
    TemplateOptions options;
    options.width = 33;
    options.height = 21;
    options.field_of_view_deg = 0.3;
    return make_template(test::small_pupil(), *find_lamp("A"), options, "A");
  }

  glare_pixels pixels_of(std::vector<float>& values, int channels) {
    glare_pixels pixels;
    EXPECT_EQ(glare_pixels_planar(&pixels, values.data(), values.size(), kWidth, kHeight, channels,
                                  &error_),
              GLARE_OK)
        << error_.message;
    return pixels;
  }

  glare_error error_ = {};
  glare_lamp* lamp_ = nullptr;
  glare_template_options options_ = {};
  glare_filter_options frames_ = {};
  glare_template* made_ = nullptr;
};

TEST_F(CInterface, TemplateIsTheLibrarys) {
  const GlareTemplate whole = expected();
  std::vector<float> values(3 * 33 * 21);
  glare_pixels pixels;
  glare_pixels_planar(&pixels, values.data(), values.size(), 33, 21, 3, &error_);
  ASSERT_EQ(glare_template_copy_pixels(made_, &pixels, &error_), GLARE_OK) << error_.message;
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(std::memcmp(&values[k * 33 * 21], whole.channels[k].values().data(),
                          33 * 21 * sizeof(float)),
              0);
  glare_template_facts facts;
  ASSERT_EQ(glare_template_get_facts(made_, &facts, sizeof facts, &error_), GLARE_OK);
  EXPECT_EQ(facts.per_steradian, whole.per_steradian);
  EXPECT_EQ(facts.captured_energy, whole.captured_energy);
  EXPECT_EQ(facts.light_xyz[2], whole.light_xyz[2]);
}

TEST_F(CInterface, PictureWithGlareIsTheLibrarys) {
  Picture picture;
  picture.channels.fill(Image<float>(kWidth, kHeight, 0.5F));
  picture.channels[1](3, 4) = 700;
  std::vector<float> values;
  for (const auto& channel : picture.channels)
    values.insert(values.end(), channel.values().begin(), channel.values().end());
  PixelScale scale;
  scale.pitch_rad = 0.011 * 3.14159265358979323846 / 180;
  apply_glare(picture, GlareFilter(pixel_kernel(expected(), scale, lin_rec709_color_space()),
                                   kWidth, kHeight));

  glare_filter* filter = nullptr;
  ASSERT_EQ(glare_filter_make(made_, &frames_, &filter, &error_), GLARE_OK) << error_.message;
  const glare_pixels pixels = pixels_of(values, 3);
  EXPECT_EQ(glare_filter_apply(filter, nullptr, &pixels, nullptr, &error_), GLARE_OK);
  glare_filter_free(filter);
  // The same but for the kernel's light beyond the picture, and rounding at 700.
  for (std::size_t i = 0; i < values.size(); ++i)
    ASSERT_NEAR(values[i],
                picture.channels[i / (kWidth * kHeight)].values()[i % (kWidth * kHeight)],
                1e-6 * 700);
}

TEST_F(CInterface, SmallConstantPictureStaysWhereItsBorderGoesOn) {
  // The template's field is many times as large as the picture.
  std::vector<float> values(3 * 2 * 3, 0.25F);
  frames_.width = 3;
  frames_.height = 2;
  frames_.edge = GLARE_EDGE_EXTEND;
  glare_filter* filter = nullptr;
  ASSERT_EQ(glare_filter_make(made_, &frames_, &filter, &error_), GLARE_OK) << error_.message;
  glare_pixels pixels;
  ASSERT_EQ(glare_pixels_planar(&pixels, values.data(), values.size(), 3, 2, 3, &error_), GLARE_OK);
  EXPECT_EQ(glare_filter_apply(filter, nullptr, &pixels, nullptr, &error_), GLARE_OK);
  glare_filter_free(filter);
  for (const float value : values) EXPECT_NEAR(value, 0.25, 1e-6);  // A few roundings of floats.
}

TEST_F(CInterface, PointsBesideAGreyPictureShineIntoIt) {
  frames_.grey = 1;
  std::vector<float> white(kWidth * kHeight), green(kWidth * kHeight);
  const glare_point a = {-2, 9, {100, 100, 100}}, b = {-2, 9, {0, 100, 0}};
  const glare_pixels of_white = pixels_of(white, 1), of_green = pixels_of(green, 1);
  ASSERT_EQ(glare_add_points(made_, &frames_, &a, 1, 1, 1, &of_white, &error_), GLARE_OK)
      << error_.message;
  ASSERT_EQ(glare_add_points(made_, &frames_, &b, 1, 1, 1, &of_green, &error_), GLARE_OK);
  EXPECT_GT(white[9 * kWidth], 0.01F);
  // ITU-R BT.709: green is 0.7152 of white's luminance, to four digits.
  EXPECT_NEAR(green[9 * kWidth] / white[9 * kWidth], 0.7152, 1e-4);
}

TEST_F(CInterface, LongMessagesAreCutBetweenCharacters) {
  std::string name = "./x";
  for (int i = 0; i < 1000; ++i) name += "\xC3\xA9";  // e with an acute accent.
  glare_lamp* lamp = nullptr;
  EXPECT_EQ(glare_lamp_find(name.c_str(), &lamp, &error_), GLARE_ERROR_INPUT);
  const std::string message = error_.message;
  EXPECT_LT(message.size(), sizeof error_.message);
  EXPECT_GT(message.size(), sizeof error_.message - 3);
  EXPECT_EQ(message.back(), '\xA9');
}

}  // namespace
}  // namespace glare
