#include "glare/spectrum/observer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include "glare/base/error.h"
#include "glare/io/sha256.h"
#include "glare/spectrum/lamps.h"

namespace glare {
namespace {

using Row = std::array<double, 4>;

struct Published {
  const char* observer;
  const char* file;
  const char* sha256;
  std::size_t rows;
  double y_bar_sum;
};

constexpr std::array<Published, 4> kPublished = {{
    {"cie1931-2deg", "cie_1931_2deg.csv",
     "445055fa58a0e804ef439f1541d122429e6689e9f646eb77322c16be9ad7eea7", 471, 106.8569},
    {"cie1964-10deg", "cie_1964_10deg.csv",
     "8ca9d79fc83a4ae4d6a8157b6f7b4c30bbe984a14140f5a413b250f132db0b91", 471, 116.6619},
    {"cie2015-2deg", "cie_2015_2deg.csv",
     "5ab6f2fcb887ce276c56af658177b86050e32da8646f04a897a42c727b72301b", 441, 113.0423},
    {"cie2015-10deg", "cie_2015_10deg.csv",
     "589623b1ef033f48950189f847977c989e2245b06fa32acf248e58dab58e5e2b", 441, 118.5181},
}};

std::string path_of(const Published& p) { return std::string(GLARE_SOURCE_DIR "/cmf/") + p.file; }

/// The file's rows, by other code than the library's.
std::vector<Row> rows_of(const Published& p) {
  std::ifstream file(path_of(p));
  std::string header;
  std::getline(file, header);
  std::vector<Row> rows;
  char comma;
  for (Row r; file >> r[0] >> comma >> r[1] >> comma >> r[2] >> comma >> r[3];) rows.push_back(r);
  return rows;
}

TEST(Observer, TheTablesAreThePublishedOnes) {
  for (const Published& p : kPublished) EXPECT_EQ(sha256_of_file(path_of(p)), p.sha256) << p.file;
}

TEST(Observer, EveryRowIsTheTables) {
  for (const Published& p : kPublished) {
    const ColorMatchingFunctions& observer = color_matching_functions(p.observer);
    const std::vector<Row> rows = rows_of(p);
    ASSERT_EQ(rows.size(), p.rows) << p.file;
    ASSERT_EQ(observer.y_bar.values().size(), p.rows);
    EXPECT_EQ(observer.name, p.observer);
    EXPECT_EQ(observer.range(), (WavelengthRange{rows.front()[0], rows.back()[0]}));
    for (const Row& row : rows) {
      ASSERT_EQ(observer.x_bar(row[0]), row[1]) << p.file << ", " << row[0];
      ASSERT_EQ(observer.y_bar(row[0]), row[2]) << p.file << ", " << row[0];
      ASSERT_EQ(observer.z_bar(row[0]), row[3]) << p.file << ", " << row[0];
    }
  }
}

TEST(Observer, TheLuminousColumnsSumToThePublishedFigures) {
  for (const Published& p : kPublished) {
    double sum = 0;
    for (const double y : color_matching_functions(p.observer).y_bar.values()) sum += y;
    EXPECT_NEAR(sum, p.y_bar_sum, 0.51e-4) << p.observer;  // Four decimals given.
  }
}

TEST(Observer, SingleRows) {
  const auto& cie1931 = color_matching_functions("cie1931-2deg");
  EXPECT_EQ(cie1931.y_bar(547), 0.9874182);  // Has been copied wrongly elsewhere.
  EXPECT_EQ(cie1931.y_bar(555), 1);
  EXPECT_EQ(cie1931.x_bar(600), 1.0622);
  EXPECT_EQ(cie1931.z_bar(450), 1.77211);
  EXPECT_EQ(color_matching_functions("cie1964-10deg").y_bar(547), 0.98652);
  EXPECT_EQ(color_matching_functions("cie2015-2deg").y_bar(547), 0.9852081);
  EXPECT_EQ(color_matching_functions("cie2015-10deg").y_bar(547), 0.9899849);
}

TEST(Observer, NamesAndAnUnknownOne) {
  EXPECT_THAT(observer_names(), testing::ElementsAre("cie1931-2deg", "cie1964-10deg",
                                                     "cie2015-2deg", "cie2015-10deg"));
  try {
    color_matching_functions("cie1931");
    FAIL();
  } catch (const OptionError& error) {
    for (const std::string& name : observer_names())
      EXPECT_THAT(error.what(), testing::HasSubstr(name));
  }
}

TEST(Observer, TristimulusValuesAreTheIntegrals) {
  const Spectrum lamp = *find_lamp("FL11");
  const auto& observer = color_matching_functions("cie2015-10deg");
  const WavelengthRange range{401.3, 688.8};  // Between samples.
  constexpr int kSteps = 287500;              // Midpoints, 0.001 nm apart.
  const double step = (range.hi_nm - range.lo_nm) / kSteps;
  Xyz sum{};
  for (int i = 0; i < kSteps; ++i) {
    const double nm = range.lo_nm + (i + 0.5) * step, light = lamp(nm) * step;
    sum[0] += light * observer.x_bar(nm);
    sum[1] += light * observer.y_bar(nm);
    sum[2] += light * observer.z_bar(nm);
  }
  const Xyz found = xyz_from_spectrum(lamp, observer, range);
  EXPECT_NEAR(luminous_integral(lamp, observer, range) / sum[1], 1, 1e-8);  // The midpoint rule's.
  EXPECT_EQ(found[1], 1);
  EXPECT_NEAR(found[0], sum[0] / sum[1], 1e-8);
  EXPECT_NEAR(found[2], sum[2] / sum[1], 1e-8);
}

TEST(Observer, ALampWithoutVisibleLightIsRefused) {
  const auto& observer = color_matching_functions("cie1931-2deg");
  const WavelengthRange range{380, 780};
  EXPECT_THROW(xyz_from_spectrum(Spectrum({900, 1000}, {1, 1}), observer, range), InputError);
  EXPECT_THROW(xyz_from_spectrum(Spectrum({400, 700}, {0, 0}), observer, range), InputError);
  EXPECT_EQ(luminous_integral(Spectrum({900, 1000}, {1, 1}), observer, range), 0);
}

TEST(Observer, ShareOfSensitivityThatALampMisses) {
  const auto& observer = color_matching_functions("cie1931-2deg");
  const WavelengthRange range{380, 780};
  const auto missed = [&](double lo, double hi) {
    return share_of_sensitivity_missed(Spectrum({lo, hi}, {1, 1}), observer, range);
  };
  EXPECT_NEAR(missed(300, 830), 0, 1e-15);
  EXPECT_NEAR(missed(380, 780), 0, 1e-15);
  EXPECT_EQ(missed(800, 830), 1);
  EXPECT_NEAR(missed(380, 560) + missed(560, 780), 1, 1e-12);
  EXPECT_NEAR(missed(400, 700), 5.85226e-4, 1e-9);  // Summed by trapezia, with another program.
  EXPECT_EQ(share_of_sensitivity_missed(Spectrum({380, 780}, {1, 1}), observer, {900, 950}), 1);
}

TEST(EffectiveWidth, OfATriangularLineIsThreeQuartersOfItsBase) {
  // (integral of S)^2 / integral of S^2; the observer hardly changes within the line.
  const Spectrum line({380, 554.9, 555, 555.1, 780}, {0, 0, 1, 0, 0});
  const auto& observer = color_matching_functions("cie1931-2deg");
  EXPECT_NEAR(effective_width_nm(line, observer, {380, 780}), 0.75 * 0.2, 1e-4);
}

}  // namespace
}  // namespace glare
