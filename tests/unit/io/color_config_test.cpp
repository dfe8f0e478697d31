#include "glare/io/color_config.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "glare/base/error.h"

namespace glare {
namespace {

// What 16 or 17 digits and a few operations in double precision may be off.
constexpr double kRounding = 1e-14;

const char* const kWithAcesRole = "  aces_interchange: reference\n";
const char* const kWithXyzRole = "  cie_xyz_d65_interchange: reference\n";
const char* const kReference = "  - !<ColorSpace> {name: reference}\n";
const char* const kAcesToXyz = "!<BuiltinTransform> {style: UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD}";

struct NamedPrimaries {
  const char* name;
  std::array<Chromaticity, 3> primaries;
  Xyz white;
};

// The table of data/color/make_config.py once more.
std::vector<NamedPrimaries> expected_built_in_spaces() {
  const std::array<Chromaticity, 3> ap0 = {{{0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}}};
  const std::array<Chromaticity, 3> ap1 = {{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}}};
  const Xyz d65 = xyz_from_chromaticity({0.3127, 0.3290});
  const Xyz aces_white = xyz_from_chromaticity({0.32168, 0.33767});
  return {{"lin_rec709", {{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}}, d65},
          {"lin_rec2020", {{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}}}, d65},
          {"lin_p3d65", {{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}}}, d65},
          {"acescg", ap1, aces_white},
          {"aces2065-1", ap0, aces_white},
          {"ntsc1953", {{{0.67, 0.33}, {0.21, 0.71}, {0.14, 0.08}}}, {0.9804, 1, 1.1812}}};
}

void expect_near(const Matrix3& actual, const Matrix3& expected, double tolerance) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      EXPECT_NEAR(actual[row][column], expected[row][column], tolerance)
          << "row " << row << ", column " << column;
}

// A MatrixTransform of a config, with every digit.
std::string matrix_transform(const Matrix3& m) {
  std::string numbers;
  for (const Vector3& row : m) {
    char text[100];
    std::snprintf(text, sizeof text, "%.17g, %.17g, %.17g, 0, ", row[0], row[1], row[2]);
    numbers += text;
  }
  return "!<MatrixTransform> {matrix: [" + numbers + "0, 0, 0, 1]}";
}

std::string color_space(const std::string& name, const std::string& to_reference,
                        const std::string& other = "") {
  return "  - !<ColorSpace>\n    name: " + name + "\n" + other +
         "    to_scene_reference: " + to_reference + "\n";
}

std::string config_text(const std::string& roles, const std::string& color_spaces) {
  return "ocio_profile_version: 2\nsearch_path: luts\nstrictparsing: true\n"
         "environment: {MATRIX_FILE: half.spimtx}\n"
         "roles:\n  default: reference\n" +
         roles +
         "displays:\n  none:\n    - !<View> {name: Raw, colorspace: reference}\n"
         "colorspaces:\n" +
         color_spaces;
}

class ColorConfig : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "glare_color_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    std::filesystem::create_directory(folder_ / "luts");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  std::filesystem::path write_config(const std::string& roles,
                                     const std::string& color_spaces) const {
    return write("user.ocio", config_text(roles, color_spaces));
  }

  // The message of an `OptionError`, which is expected.
  static std::string refusal(const std::string& name, const std::filesystem::path& config = {}) {
    try {
      find_color_space(name, config);
    } catch (const OptionError& error) {
      return error.what();
    }
    ADD_FAILURE() << name << " was not refused";
    return "";
  }

  // The message of an `InputError` whose place is the config, which is expected.
  static std::string input_error(const std::string& name, const std::filesystem::path& config) {
    try {
      find_color_space(name, config);
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), config.string());
      return error.what();
    }
    ADD_FAILURE() << config << " was accepted";
    return "";
  }

  std::filesystem::path folder_;
};

void expect_mentions(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST_F(ColorConfig, TheBuiltInNamesAreThoseOfTheManual) {
  const std::vector<std::string> expected = {"xyz",    "lin_rec709", "lin_rec2020", "lin_p3d65",
                                             "acescg", "aces2065-1", "ntsc1953"};
  EXPECT_EQ(built_in_color_space_names(), expected);
}

TEST_F(ColorConfig, BuiltInSpacesAreTheirPrimariesAndWhite) {
  for (const NamedPrimaries& expected : expected_built_in_spaces()) {
    SCOPED_TRACE(expected.name);
    const RgbColorSpace found = find_color_space(expected.name);
    const RgbColorSpace made(expected.name, expected.primaries, expected.white);
    EXPECT_EQ(found.name(), expected.name);
    expect_near(found.rgb_from_xyz(), made.rgb_from_xyz(), kRounding);
    expect_near(found.xyz_from_rgb(), made.xyz_from_rgb(), kRounding);
  }
}

// OpenColorIO tells no upper from lower case, and the built-in names are of lower case: so these
// are the config's own spaces, from matrices worked out in exact fractions, by way of its ACES
// role.
TEST_F(ColorConfig, TheConfigForOtherProgramsHasTheBuiltInSpaces) {
  const std::filesystem::path config = GLARE_SOURCE_DIR "/data/color/glare.ocio";
  for (const std::string& name : built_in_color_space_names()) {
    SCOPED_TRACE(name);
    std::string upper_case = name;
    for (char& c : upper_case) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    expect_near(find_color_space(upper_case, config).rgb_from_xyz(),
                find_color_space(name).rgb_from_xyz(), kRounding);
  }
}

TEST_F(ColorConfig, BuiltInRec709IsThatOfTheCore) {
  expect_near(find_color_space("lin_rec709").rgb_from_xyz(),
              lin_rec709_color_space().rgb_from_xyz(), kRounding);
}

TEST_F(ColorConfig, XyzIsXyzItself) {
  EXPECT_TRUE(find_color_space("xyz").is_xyz());
  EXPECT_EQ(find_color_space("xyz").name(), "xyz");
}

TEST_F(ColorConfig, ABuiltInNameIsBuiltInWhateverTheUsersConfigHolds) {
  const auto config = write_config(
      kWithXyzRole, kReference + color_space("lin_rec709", matrix_transform(identity_matrix())));
  EXPECT_FALSE(find_color_space("lin_rec709", config).is_xyz());
  EXPECT_FALSE(find_color_space("lin_rec709", folder_ / "missing.ocio").is_xyz());
}

TEST_F(ColorConfig, TheAcesRoleTiesAConfigToXyzWithItsAdaptation) {
  const std::string rec709_from_aces =
      "!<GroupTransform> {children: [" + std::string(kAcesToXyz) + ", " +
      matrix_transform(lin_rec709_color_space().rgb_from_xyz()) + "]}";
  const auto config = write_config(
      kWithAcesRole, std::string(kReference) +
                         "  - !<ColorSpace>\n    name: Linear BT.709\n    aliases: [bt709]\n"
                         "    encoding: scene-linear\n    from_scene_reference: " +
                         rec709_from_aces + "\n");
  for (const char* name : {"Linear BT.709", "linear bt.709", "bt709"}) {
    const RgbColorSpace space = find_color_space(name, config);
    EXPECT_EQ(space.name(), name);
    // OpenColorIO writes the white of its own matrix with 14 decimals.
    expect_near(space.rgb_from_xyz(), lin_rec709_color_space().rgb_from_xyz(), 1e-12);
  }
}

TEST_F(ColorConfig, TheAcesWhiteOfAUsersConfigIsD65) {
  const auto config = write_config(kWithAcesRole, kReference);
  const Xyz d65 = xyz_from_chromaticity({0.3127, 0.3290});
  for (const char* name : {"reference", "aces_interchange", "default"}) {
    const RgbColorSpace space = find_color_space(name, config);
    EXPECT_EQ(space.name(), name);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(space.white_xyz()[k], d65[k], kRounding);
  }
}

TEST_F(ColorConfig, AUsersXyzIsXyzItself) {
  const auto config =
      write_config(kWithAcesRole, kReference +
                                      std::string("  - !<ColorSpace>\n    name: CIE\n"
                                                  "    from_scene_reference: ") +
                                      kAcesToXyz + "\n");
  EXPECT_TRUE(find_color_space("CIE", config).is_xyz());
}

TEST_F(ColorConfig, TheXyzRoleServesWhereThereIsNoAcesRole) {
  const auto config = write_config(
      kWithXyzRole,
      kReference + color_space("mine", matrix_transform(lin_rec709_color_space().xyz_from_rgb())));
  expect_near(find_color_space("mine", config).rgb_from_xyz(),
              lin_rec709_color_space().rgb_from_xyz(), kRounding);
}

TEST_F(ColorConfig, TheXyzRoleMayBeADisplaySpaceBehindALinearView) {
  const auto config = write_config(
      "  cie_xyz_d65_interchange: display\n",
      std::string(kReference) +
          "display_colorspaces:\n  - !<ColorSpace> {name: display}\n"
          "view_transforms:\n  - !<ViewTransform>\n    name: plain\n    from_scene_reference: " +
          matrix_transform(lin_rec709_color_space().xyz_from_rgb()) + "\n");
  expect_near(find_color_space("reference", config).rgb_from_xyz(),
              lin_rec709_color_space().rgb_from_xyz(), kRounding);
}

TEST_F(ColorConfig, AConfigOfVersion1IsRead) {
  const auto config = write(
      "version1.ocio",
      "ocio_profile_version: 1\nroles: {default: reference, aces_interchange: reference}\n"
      "displays: {none: [!<View> {name: Raw, colorspace: reference}]}\n"
      "colorspaces:\n  - !<ColorSpace> {name: reference, bitdepth: 32f, allocation: lg2}\n"
      "  - !<ColorSpace>\n    name: squared\n    to_reference: !<ExponentTransform> {value: 2}\n");
  EXPECT_NEAR(find_color_space("reference", config).white_xyz()[1], 1, kRounding);
  expect_mentions(refusal("squared", config), "isn't scene-linear");
}

TEST_F(ColorConfig, AConfigWithoutInterchangeRolesIsAnError) {
  const auto config = write_config("", kReference);
  expect_mentions(input_error("reference", config), "aces_interchange");
}

TEST_F(ColorConfig, ASpaceThatSaysItIsNotSceneLinearIsRefused) {
  const std::string identity = matrix_transform(identity_matrix());
  std::string spaces = kReference + color_space("raw", identity, "    isdata: true\n");
  const char* const encodings[] = {"log", "sdr-video", "hdr-video", "display-linear", "data"};
  for (const std::string encoding : encodings)
    spaces += color_space("a-" + encoding, identity, "    encoding: " + encoding + "\n");
  const auto config = write_config(
      kWithXyzRole, spaces + "display_colorspaces:\n  - !<ColorSpace> {name: screen}\n");
  expect_mentions(refusal("raw", config), "data");
  expect_mentions(refusal("screen", config), "display");
  for (const std::string encoding : encodings)
    expect_mentions(refusal("a-" + encoding, config), "its encoding is " + encoding);
}

TEST_F(ColorConfig, ASpaceThatIsFoundNotToBeLinearIsRefused) {
  const auto config = write_config(
      kWithXyzRole,
      kReference +
          color_space("log", "!<LogTransform> {base: 2, direction: inverse}",
                      "    encoding: scene-linear\n") +
          color_space("srgb", "!<ExponentWithLinearTransform> {gamma: 2.4, offset: 0.055}") +
          color_space("offset", "!<MatrixTransform> {offset: [1e-3, 0, 0, 0]}") +
          color_space("clamped", "!<RangeTransform> {min_in_value: 0, min_out_value: 0}"));
  for (const char* name : {"log", "srgb", "offset", "clamped"})
    expect_mentions(refusal(name, config), "isn't scene-linear");
}

TEST_F(ColorConfig, ALinearSpaceMadeOfMoreThanMatricesIsMeasured) {
  const auto config = write_config(
      kWithXyzRole, kReference + color_space("mine",
                                             "!<GroupTransform> {children: [!<CDLTransform> "
                                             "{slope: [0.9505, 1, 1.089], style: noclamp}]}"));
  // Measured with pixels in float32.
  expect_near(find_color_space("mine", config).xyz_from_rgb(), diagonal_matrix({0.9505, 1, 1.089}),
              1e-6);
}

TEST_F(ColorConfig, AWhiteOfAnotherLuminanceIsRefused) {
  const auto config = write_config(
      kWithXyzRole,
      kReference + color_space("nits", matrix_transform(diagonal_matrix({0.01, 0.01, 0.01}))));
  expect_mentions(refusal("nits", config), "luminance 0.01");
}

TEST_F(ColorConfig, FilesAreFoundBesideTheConfig) {
  write("luts/half.spimtx", "0.5 0.25 0.25 0\n0 1 0 0\n0 0 1 0\n");
  const auto config = write_config(
      kWithXyzRole, kReference + color_space("mine", "!<FileTransform> {src: half.spimtx}") +
                        color_space("variable", "!<FileTransform> {src: $MATRIX_FILE}"));
  const Matrix3 expected = {{{0.5, 0.25, 0.25}, {0, 1, 0}, {0, 0, 1}}};
  const auto relative = std::filesystem::relative(config);
  for (const char* name : {"mine", "variable"})
    for (const auto& path : {config, relative})
      expect_near(find_color_space(name, path).xyz_from_rgb(), expected, kRounding);
}

TEST_F(ColorConfig, ACubeThatClampsIsRefused) {
  write("luts/identity.cube",
        "LUT_3D_SIZE 2\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n");
  const auto config = write_config(
      kWithXyzRole, kReference + color_space("mine", "!<FileTransform> {src: identity.cube}"));
  expect_mentions(refusal("mine", config), "isn't scene-linear");
}

TEST_F(ColorConfig, ABrokenOrMissingFileIsAnError) {
  write("luts/broken.cube", "LUT_3D_SIZE 2\n0 0 0\n");
  const auto config = write_config(
      kWithXyzRole, kReference + color_space("broken", "!<FileTransform> {src: broken.cube}") +
                        color_space("missing", "!<FileTransform> {src: missing.cube}"));
  expect_mentions(input_error("broken", config), "broken.cube");
  expect_mentions(input_error("missing", config), "missing.cube");
}

TEST_F(ColorConfig, AMatrixThatCannotBeInvertedIsAnError) {
  const auto config = write_config(
      kWithXyzRole, kReference +
                        color_space("flat", matrix_transform({{{1, 0, 0}, {1, 0, 0}, {0, 0, 1}}})) +
                        "  - !<ColorSpace>\n    name: flat too\n    from_scene_reference: " +
                        matrix_transform({{{1, 0, 0}, {1, 0, 0}, {0, 0, 1}}}) + "\n");
  input_error("flat", config);
  input_error("flat too", config);
}

TEST_F(ColorConfig, AnUnknownNameListsTheKnownOnes) {
  const std::string message = refusal("lin_rec708");
  expect_mentions(message, "lin_rec708");
  for (const std::string& name : built_in_color_space_names()) expect_mentions(message, name);
  expect_mentions(message, "no OpenColorIO config");
  refusal("");
  refusal("LIN_REC709");
  refusal("aces2065-1_bradford_d65");
}

TEST_F(ColorConfig, AnUnknownNameNamesTheSpacesMostLikeIt) {
  const std::string identity = matrix_transform(identity_matrix());
  std::string spaces = kReference + color_space("camera log", identity, "    encoding: log\n");
  for (int i = 10; i < 30; ++i) spaces += color_space("camera " + std::to_string(i), identity);
  const auto config = write_config(kWithXyzRole, spaces);
  const std::string message = refusal("camera 29b", config);
  expect_mentions(message, config.string());
  expect_mentions(message, "it has camera 29, ");
  EXPECT_EQ(message.find("camera log"), std::string::npos);
  const std::string list = message.substr(message.find("it has"));
  EXPECT_EQ(std::count(list.begin(), list.end(), ','), 9) << message;  // ten names
  refusal("", config);
}

TEST_F(ColorConfig, ABrokenOrMissingConfigIsAnError) {
  input_error("mine", folder_ / "missing.ocio");
  input_error("mine", folder_);
  input_error("mine", write("empty.ocio", ""));
  input_error("mine", write("text.ocio", "It isn't a config: [\n"));
  input_error("mine", write("binary.ocio", std::string("PK\3\4\0\0\1\377", 8)));
  input_error("mine", write("future.ocio", "ocio_profile_version: 99\n"));
}

TEST_F(ColorConfig, NothingIsPrinted) {
  if (std::getenv("OCIO_LOGGING_LEVEL")) GTEST_SKIP() << "the environment asks for messages";
  const std::string text = config_text(kWithXyzRole, kReference);
  const auto config = write("user.ocio", "unknown_key: 1\n" + text);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_TRUE(find_color_space("reference", config).is_xyz());
  input_error("mine", folder_ / "missing.ocio");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

class Environment : public testing::Test {
 protected:
  void SetUp() override {
    if (const char* value = std::getenv("OCIO")) before_ = value;
  }
  void TearDown() override {
    if (before_)
      setenv("OCIO", before_->c_str(), 1);
    else
      unsetenv("OCIO");
  }

  std::optional<std::string> before_;
};

TEST_F(Environment, NamesTheConfigOrNone) {
  setenv("OCIO", "/studio/config.ocio", 1);
  EXPECT_EQ(color_config_from_environment(), "/studio/config.ocio");
  EXPECT_FALSE(find_color_space("xyz").name().empty());  // a built-in space doesn't look there
  setenv("OCIO", "", 1);
  EXPECT_TRUE(color_config_from_environment().empty());
  unsetenv("OCIO");
  EXPECT_TRUE(color_config_from_environment().empty());
}

}  // namespace
}  // namespace glare
