#include "glare/io/zernike_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glare/base/error.h"

namespace glare {
namespace {

using testing::ElementsAre;

TEST(ZernikeFile, HasADiameterAndRowsOfEitherKind) {
  const auto single =
      parse_zernike_table("# eye\npupil_diameter_mm, 6.5\r\nj,um\n4,+0.1 # x\n12,-2e-2", "f");
  EXPECT_EQ(single.pupil_diameter_mm, 6.5);
  EXPECT_THAT(single.coefficients,
              ElementsAre(ZernikeCoefficient{4, 0.1}, ZernikeCoefficient{12, -0.02}));
  const auto pairs = parse_zernike_table("pupil_diameter_mm,6\n3,-1,0.14\n4,0,0.13\n", "f");
  EXPECT_THAT(pairs.coefficients,
              ElementsAre(ZernikeCoefficient{7, 0.14}, ZernikeCoefficient{12, 0.13}));
}

TEST(ZernikeFile, TheExampleIsRead) {
  const auto eye = read_zernike_file(GLARE_SOURCE_DIR "/data/wavefront/typical_eye_6mm.csv");
  EXPECT_EQ(eye.pupil_diameter_mm, 6);
  EXPECT_EQ(eye.coefficients.size(), 3u);
}

std::string place_of_refusal(const std::string& text) {
  try {
    parse_zernike_table(text, "f");
  } catch (const InputError& error) {
    return error.place();
  }
  return "(was accepted)";
}

TEST(ZernikeFile, ErrorsTellTheLine) {
  const std::string start = "pupil_diameter_mm,6\n";
  EXPECT_EQ(place_of_refusal(""), "f");
  EXPECT_EQ(place_of_refusal("4,0.1\n"), "f");
  EXPECT_EQ(place_of_refusal(start), "f");
  EXPECT_EQ(place_of_refusal("pupil_diameter_mm,0\n4,1\n"), "f:1");
  EXPECT_EQ(place_of_refusal(start + "pupil_diameter_mm,6\n"), "f:2");
  for (const char* row : {"4,0.1,0.2", "4", "231,0.1", "-1,0.1", "1.5,0.1", "4,1e9", "4,nan", "4,x",
                          "2,1,0.1", "4,0.1,0,1"})
    EXPECT_EQ(place_of_refusal(start + row), "f:2") << row;
  EXPECT_EQ(place_of_refusal(start + "4,0.1\n5,0.1\n4,0.2"), "f:4");
  EXPECT_EQ(place_of_refusal(start + "4,0.1\n3,1,0.2"), "f:3");
  EXPECT_EQ(place_of_refusal(start + "4,0.1\nwords,x"), "f:3");
  EXPECT_EQ(place_of_refusal(std::string("4,\0", 3)), "f");
}

}  // namespace
}  // namespace glare
