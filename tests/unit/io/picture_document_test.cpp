// OpenEXR files: what isn't changed stays as it is.
#include "glare/io/picture_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "support/image_bytes.h"
#include "support/picture_document_fixture.h"

namespace glare::test {
namespace {

using std::string_literals::operator""s;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The number of places where two files of one size differ; -1 where the sizes do.
int differences(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return -1;
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
  return count;
}

/// The header, up to the first table's first entry.
std::string header_of(const std::string& file) {
  const std::size_t end = file.find("screenWindowWidth\0float"s);
  return file.substr(0, end == std::string::npos ? 0 : end + 33);
}

// Pixels that are stored as they are, and all parts that are only copied, give the same bytes in
// every version of OpenEXR.
TEST_F(PictureDocumentTest, UnchangedPicturesAreTheSameFile) {
  for (const char* name : {"kept_rows.exr", "kept_tiles.exr", "kept_parts.exr"})
    EXPECT_EQ(differences(written(read(fixture(name))), content_of(fixture(name))), 0) << name;
  const PictureDocument tiles = read(fixture("kept_parts.exr"), 1);
  EXPECT_EQ(differences(written(tiles), content_of(fixture("kept_parts.exr"))), 0);
}

TEST_F(PictureDocumentTest, CompressedPicturesStayThemselves) {
  for (const char* name : {"kept_upwards_zip.exr", "kept_tiles_piz.exr", "kept_pxr24.exr"}) {
    const std::string first = written(read(fixture(name)));
    EXPECT_EQ(header_of(first), header_of(content_of(fixture(name)))) << name;
    for (const char* layer : {"", "diffuse", "Z", "A", "right"}) {
      const Picture before = read(fixture(name), -1, layer).picture();
      const Picture after = read(folder_ / "out.exr", -1, layer).picture();
      for (int k = 0; k < 3; ++k)
        EXPECT_TRUE(std::ranges::equal(before.channels[k].values(), after.channels[k].values()))
            << name << " " << layer;
    }
  }
}

TEST_F(PictureDocumentTest, OnlyTheColorsChange) {
  const std::string before = content_of(fixture("kept_rows.exr"));
  // 16 x 12 pixels of two halves and a float: doubling adds one to an exponent, in one byte of each
  // half and in one or two of each float.
  const int changed = differences(written(read(fixture("kept_rows.exr")), 2), before);
  EXPECT_GE(changed, 16 * 12 * 3);
  EXPECT_LE(changed, 16 * 12 * 4);
  const PictureDocument after = read(folder_ / "out.exr");
  EXPECT_EQ(after.picture().channels[2](15, 11),
            2 * read(fixture("kept_rows.exr")).picture().channels[2](15, 11));
}

TEST_F(PictureDocumentTest, OfSeveralPartsOneChanges) {
  written(read(fixture("kept_parts.exr"), 1), 2);
  for (const int part : {0, 1, 3}) {
    const Picture before = read(fixture("kept_parts.exr"), part).picture();
    const Picture after = read(folder_ / "out.exr", part).picture();
    for (std::size_t i = 0; i < before.channels[0].values().size(); ++i)
      EXPECT_EQ(after.channels[0].values()[i],
                before.channels[0].values()[i] * (part == 1 ? 2 : 1));
  }
}

TEST_F(PictureDocumentTest, LayersAreReadAndWritten) {
  const PictureDocument diffuse = read(fixture("kept_rows.exr"), 0, "diffuse");
  EXPECT_FALSE(diffuse.is_gray());
  EXPECT_NE(pixel(diffuse.picture(), 3, 4), pixel(read(fixture("kept_rows.exr")).picture(), 3, 4));
  EXPECT_EQ(differences(written(diffuse), content_of(fixture("kept_rows.exr"))), 0);
  const PictureDocument depth = read(fixture("kept_rows.exr"), 0, "Z");
  EXPECT_TRUE(depth.is_gray());
  Picture changed = depth.picture();
  changed.channels[0](2, 1) = -7;
  changed.channels[1](2, 1) = 99;  // Not looked at.
  depth.write(folder_ / "out.exr", changed);
  EXPECT_EQ(pixel(read(folder_ / "out.exr", 0, "Z").picture(), 2, 1), (Values{-7, -7, -7}));
  EXPECT_EQ(pixel(read(folder_ / "out.exr").picture(), 2, 1),
            pixel(read(fixture("kept_rows.exr")).picture(), 2, 1));
}

TEST_F(PictureDocumentTest, TellsTheLayersThereAre) {
  const std::string file = content_of(fixture("kept_rows.exr"));
  EXPECT_THAT(refused(file, 0, "spec"),
              HasSubstr("no colours in a layer spec; its layers are diffuse, right"));
  EXPECT_THAT(refused(file, 1), HasSubstr("has no part 1; it has 1, counted from 0"));
  EXPECT_THAT(refused(exr({.channels = {"U", "V"}, .rows = {0, 0, 0, 0}})),
              HasSubstr("has channels U, V"));
  EXPECT_THAT(refused(file, 0, "id"), HasSubstr("whole numbers"));
  EXPECT_THAT(refused(file, 0, "quarter"), HasSubstr("subsampled"));
}

TEST_F(PictureDocumentTest, ChannelsOfOtherNames) {
  EXPECT_EQ(
      pixel(document(exr({.channels = {"b", "g", "r"}, .rows = {1, 2, 3, 4, 5, 6}})).picture(), 0,
            0),
      (Values{5, 3, 1}));
  const PictureDocument xyz =
      document(exr({.channels = {"X", "Y", "Z"}, .rows = {1, 2, 3, 4, 5, 6}}));
  EXPECT_TRUE(xyz.picture().color_space.is_xyz());
  EXPECT_EQ(pixel(xyz.picture(), 0, 0), (Values{1, 3, 5}));
  const PictureDocument gray = document(exr({.channels = {"A", "foo"}, .rows = {1, 1, 3, 4}}));
  EXPECT_TRUE(gray.is_gray());
  EXPECT_EQ(pixel(gray.picture(), 1, 0), (Values{4, 4, 4}));
}

TEST_F(PictureDocumentTest, HalvesAreLimitedAndCounted) {
  const PictureDocument document = read(fixture("kept_rows.exr"));
  const float inf = std::numeric_limits<float>::infinity();
  Picture changed = document.picture();
  changed.channels[0](0, 0) = 1e6f;
  changed.channels[1](0, 0) = -1e6f;  // The same pixel.
  changed.channels[1](1, 0) = 70000;
  changed.channels[2](2, 0) = 1e30f;  // A float.
  changed.channels[0](3, 0) = inf;
  changed.channels[0](4, 0) = std::nanf("");
  EXPECT_EQ(document.write(folder_ / "out.exr", changed), 2u);
  const Picture back = read(folder_ / "out.exr").picture();
  EXPECT_EQ(pixel(back, 0, 0)[0], 65504);
  EXPECT_EQ(pixel(back, 0, 0)[1], -65504);
  EXPECT_EQ(pixel(back, 1, 0)[1], 65504);
  EXPECT_EQ(pixel(back, 2, 0)[2], 1e30f);
  EXPECT_EQ(pixel(back, 3, 0)[0], inf);
  EXPECT_TRUE(std::isnan(pixel(back, 4, 0)[0]));
}

TEST_F(PictureDocumentTest, WarnsOfWhatIsNotKept) {
  EXPECT_THAT(read(fixture("kept_rows.exr")).warnings(), IsEmpty());
  EXPECT_THAT(read(fixture("kept_pxr24.exr")).warnings(), IsEmpty());
  for (const char* lossy : {"kept_b44.exr", "kept_dwaa.exr"})
    EXPECT_THAT(read(fixture(lossy)).warnings(), ElementsAre(HasSubstr("lossy"))) << lossy;
  const PictureDocument levels = read(fixture("kept_mipmap.exr"));
  EXPECT_THAT(levels.warnings(), ElementsAre(HasSubstr("several levels")));
  written(levels, 2);
  EXPECT_EQ(pixel(read(folder_ / "out.exr").picture(), 6, 3)[2],
            2 * pixel(levels.picture(), 6, 3)[2]);
  const std::string map = attribute("envmap", "envmap", "\0"s);
  EXPECT_THAT(document(exr({.rows = {1, 2}, .extra = map})).warnings(),
              ElementsAre(HasSubstr("environment map")));
}

// Of DWA: the same pixels take less where the attribute asks for a larger loss.
TEST_F(PictureDocumentTest, TheLevelOfLossIsKept) {
  const std::string file = content_of(fixture("kept_dwaa.exr"));
  const std::string name = "dwaCompressionLevel\0float\0"s;
  const std::string fine = written(document(with(file, name, float_bytes(1))));
  const std::string rough = written(document(with(file, name, float_bytes(2000))));
  EXPECT_LT(rough.size() + 50, fine.size());
}

TEST_F(PictureDocumentTest, UnknownAttributesAndTheTypeStay) {
  for (const std::string& extra :
       {attribute("mine", "someType", "abc"), attribute("type", "string", "scanlineimage"), ""s}) {
    const std::string file = exr({.rows = {1, 2}, .extra = extra});
    const std::string out = written(document(file));
    EXPECT_EQ(out.find(extra) != std::string::npos, true);
    EXPECT_EQ(out.size(), file.size());
  }
}

TEST_F(PictureDocumentTest, LongAndSmallPictures) {
  Values rows(2 * 16384);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = 0.5f * static_cast<float>(i);
  const std::string wide =
      exr({.width = 16384, .height = 2, .full_width = 16384, .full_height = 2, .rows = rows});
  EXPECT_EQ(document(wide).picture().channels[1](16383, 1), 0.5f * 32767);
  EXPECT_EQ(written(document(wide)), wide);
  const std::string one = exr({.width = 1, .height = 1, .rows = {3}});
  EXPECT_EQ(written(document(one)), one);
}

TEST_F(PictureDocumentTest, SameBytesForAnyNumberOfThreads) {
  const PictureDocument document = read(fixture("kept_upwards_zip.exr"));
  document.write(folder_ / "1.exr", document.picture(), {1, {}});
  document.write(folder_ / "2.exr", document.picture(), {2, {}});
  EXPECT_EQ(content_of(folder_ / "1.exr"), content_of(folder_ / "2.exr"));
}

TEST_F(PictureDocumentTest, AllOrNothing) {
  const PictureDocument document = read(fixture("kept_parts.exr"));
  EXPECT_THROW(document.write(folder_ / "out.exr", document.picture(), {0, [] { return false; }}),
               Cancelled);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.exr"));
  EXPECT_THROW(document.write(folder_ / "no" / "out.exr", document.picture()), OutputError);
  EXPECT_THROW(document.write(folder_ / "out.png", document.picture()), OptionError);
  EXPECT_THROW(document.write(folder_ / "out.exr", Picture{}), OptionError);
}

}  // namespace
}  // namespace glare::test
