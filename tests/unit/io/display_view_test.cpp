// Pictures through the displays and views of a user's config.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "glare/base/error.h"
#include "glare/io/color_config.h"
#include "support/scratch_folder.h"

namespace glare {
namespace {

using testing::HasSubstr;

// OpenColorIO's fast power function.
constexpr double kTolerance = 2e-5;

// "Film" halves X, leaves Y, doubles Z, and takes the square root of all; "Dim" is a tenth.
const char* const kConfig = R"(ocio_profile_version: 2
strictparsing: true
roles:
  default: reference
  @ROLE@: reference
displays:
  Monitor:
    - !<View> {name: Film, colorspace: film}
    - !<View> {name: Raw, colorspace: reference}
  Projector:
    - !<View> {name: Dim, colorspace: dim}
    - !<View> {name: Broken, colorspace: broken}
colorspaces:
  - !<ColorSpace> {name: reference}
  - !<ColorSpace>
    name: film
    from_scene_reference: !<GroupTransform>
      children:
        - !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1]}
        - !<ExponentTransform> {value: [0.5, 0.5, 0.5, 1]}
  - !<ColorSpace>
    name: dim
    from_scene_reference: !<MatrixTransform>
      matrix: [0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 1]
  - !<ColorSpace>
    name: broken
    from_scene_reference: !<FileTransform> {src: missing.spimtx}
)";

class DisplayView : public testing::Test {
 protected:
  std::filesystem::path config(const std::string& role) const {
    std::string text = kConfig;
    text.replace(text.find("@ROLE@"), 6, role);
    std::ofstream(folder_ / "config.ocio") << text;
    return folder_ / "config.ocio";
  }
  std::string refusal(const std::string& display, const std::string& view) const {
    try {
      displayed(picture_, config("cie_xyz_d65_interchange"), display, view);
    } catch (const OptionError& error) {
      return error.what();
    }
    return "nothing was refused";
  }

  test::ScratchFolder folder_;
  Picture picture_ = [] {
    Picture picture;
    picture.channels = {Image<float>(2, 1, 0.5f), Image<float>(2, 1, 0.25f),
                        Image<float>(2, 1, 0.125f)};
    picture.channels[1](1, 0) = 0.75f;
    picture.color_space = xyz_color_space();
    return picture;
  }();
};

TEST_F(DisplayView, ViewsAreApplied) {
  const auto film = displayed(picture_, config("cie_xyz_d65_interchange"), "Monitor", "Film");
  ASSERT_EQ(film.width(), 2);
  for (int k = 0; k < 3; ++k)  // sqrt(0.25) of all three.
    EXPECT_NEAR(film(0, 0)[k], 0.5, kTolerance);
  EXPECT_NEAR(film(1, 0)[1], std::sqrt(0.75), kTolerance);
  const auto dim = displayed(picture_, config("cie_xyz_d65_interchange"), "Projector", "Dim");
  EXPECT_NEAR(dim(1, 0)[1], 0.075, kTolerance);
}

TEST_F(DisplayView, EmptyNamesAreTheDefaults) {
  const auto both = displayed(picture_, config("cie_xyz_d65_interchange"));
  EXPECT_NEAR(both(0, 0)[0], 0.5, kTolerance);  // Monitor, Film.
  const auto view = displayed(picture_, config("cie_xyz_d65_interchange"), "projector");
  EXPECT_NEAR(view(0, 0)[0], 0.05, kTolerance);  // Dim.
}

TEST_F(DisplayView, ColorsGoByCieXyz) {
  picture_.color_space = lin_rec709_color_space();
  const Vector3 xyz = lin_rec709_color_space().xyz_from_rgb() * Vector3{0.5, 0.25, 0.125};
  const auto raw = displayed(picture_, config("cie_xyz_d65_interchange"), "", "raw");
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(raw(0, 0)[k], xyz[k], kTolerance);
}

TEST_F(DisplayView, WhiteOfAcesInterchangeIsD65) {
  // White of BT.709, D65, is R = G = B in ACES2065-1 as the role means it.
  picture_.color_space = lin_rec709_color_space();
  for (auto& channel : picture_.channels) channel(0, 0) = 0.5f;
  const auto raw = displayed(picture_, config("aces_interchange"), "Monitor", "Raw");
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(raw(0, 0)[k], 0.5, 1e-4);  // D65 has four decimals.
  // And what find_color_space takes for its space is the same: there and back.
  picture_.color_space = find_color_space("reference", config("aces_interchange"));
  const auto same = displayed(picture_, config("aces_interchange"), "Monitor", "Raw");
  EXPECT_NEAR(same(1, 0)[1], 0.75, kTolerance);
  EXPECT_NEAR(same(1, 0)[2], 0.125, kTolerance);
}

TEST_F(DisplayView, SaysWhichDisplaysAndViewsThereAre) {
  EXPECT_THAT(refusal("Phone", ""), HasSubstr("unknown display 'Phone'"));
  EXPECT_THAT(refusal("Phone", ""), HasSubstr("Monitor, Projector"));
  EXPECT_THAT(refusal("Monitor", "Dim"), HasSubstr("unknown view 'Dim': display 'Monitor' of "));
  EXPECT_THAT(refusal("Monitor", "Dim"), HasSubstr("has Film, Raw"));
}

TEST_F(DisplayView, RefusesConfigsThatItCannotUse) {
  EXPECT_THROW(displayed(picture_, folder_ / "none.ocio"), InputError);
  EXPECT_THROW(displayed(picture_, config("rendering")), InputError);  // Neither of the roles.
  try {
    displayed(picture_, config("cie_xyz_d65_interchange"), "Projector", "Broken");
    ADD_FAILURE() << "nothing was refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("its view 'Broken' of display 'Projector' can't be used"));
  }
}

}  // namespace
}  // namespace glare
