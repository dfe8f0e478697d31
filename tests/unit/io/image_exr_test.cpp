// OpenEXR files.
#include "glare/io/image_file.h"

#include <gtest/gtest.h>

#include <string>

#include "support/image_bytes.h"
#include "support/image_file_fixture.h"

namespace glare::test {
namespace {

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

}  // namespace
}  // namespace glare::test
