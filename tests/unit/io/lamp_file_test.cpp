#include "glare/io/lamp_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "glare/base/error.h"
#include "support/scratch_folder.h"

namespace glare {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(LampFile, IsNamedByItsFileWithoutTheFolder) {
  const test::ScratchFolder folder;
  test::set_file_text(folder / "street.csv", "nm;W\n380;1,5\n780;2\n");
  const NamedLamp lamp = read_lamp_table(folder / "street.csv");
  EXPECT_EQ(lamp.name, "street.csv");
  EXPECT_EQ(lamp.file, folder / "street.csv");
  EXPECT_THAT(lamp.spectrum.values(), ElementsAre(1.5, 2));
  EXPECT_EQ(lamp_from((folder / "street.csv").string()).name, "street.csv");
}

TEST(LampFile, BuiltInNamesHaveNoFile) {
  for (const char* name : {"D65", "hid", "led_b3", "blackbody:3200"}) {
    const NamedLamp lamp = lamp_from(name);
    EXPECT_EQ(lamp.name, name);
    EXPECT_TRUE(lamp.file.empty());
  }
}

TEST(LampFile, AWordThatIsNoLampIsAnOptionAndAPathAnInput) {
  EXPECT_THROW(lamp_from("candle"), OptionError);
  EXPECT_THROW(lamp_from(""), OptionError);
  EXPECT_THROW(lamp_from("blackbody:100"), OptionError);
  EXPECT_THROW(lamp_from("/no/such/folder/lamp"), InputError);
  EXPECT_THROW(lamp_from("candle.csv"), InputError);
}

std::string place_of_refusal(const std::filesystem::path& path) {
  try {
    read_lamp_table(path);
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(error.place()));
    return error.place();
  }
  return "(was accepted)";
}

TEST(LampFile, ErrorsTellTheFileAndTheLine) {
  const test::ScratchFolder folder;
  const auto path = folder / "lamp.csv";
  test::set_file_text(path, "nm,W\n380,1\n390,x\n");
  EXPECT_EQ(place_of_refusal(path), path.string() + ":3");
  test::set_file_text(path, "");
  EXPECT_EQ(place_of_refusal(path), path.string());
  test::set_file_text(path, std::string("380,1\n390,\0 2\n", 14));
  EXPECT_EQ(place_of_refusal(path), path.string());
  EXPECT_EQ(place_of_refusal(folder / "none.csv"), (folder / "none.csv").string());
  EXPECT_EQ(place_of_refusal(folder / "."), (folder / ".").string());
}

}  // namespace
}  // namespace glare
