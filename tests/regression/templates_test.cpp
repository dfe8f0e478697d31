// Stored templates: the command of each makes the same picture as when it was stored. A difference
// that is meant is stored anew with tests/regression/update_templates.sh.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "glare/glare.h"
#include "glare/glare_io.h"
#include "support/apertures.h"

namespace glare {
namespace {

namespace fs = std::filesystem;

/// Share of a pixel's own luminance, and of the mean over all pixels of that share. Compilers and
/// FFTW's codelets differ in the last digits, which dark pixels between bright ones magnify.
constexpr double kLargestDifference = 2e-3, kMeanDifference = 1e-4;

const fs::path kFolder = fs::path(GLARE_SOURCE_DIR) / "tests/regression";

struct StoredTemplate {
  std::string name, options;
  fs::path file() const { return kFolder / "templates" / (name + ".exr"); }
};

void PrintTo(const StoredTemplate& stored, std::ostream* out) { *out << stored.name; }

std::vector<StoredTemplate> stored_templates() {
  std::vector<StoredTemplate> result;
  std::ifstream file(kFolder / "commands.txt");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    StoredTemplate stored;
    if (!(words >> stored.name) || stored.name[0] == '#') continue;
    std::getline(words, stored.options);
    result.push_back(stored);
  }
  return result;
}

void write_picture(const fs::path& path, const Aperture& aperture) {
  write_file_atomically(path, encode_png_gray16(aperture.transmittance));
}

/// A folder with the aperture pictures that the commands name.
fs::path working_folder() {
  static const fs::path folder = [] {
    const fs::path path = fs::path(testing::TempDir()) /
                          ("glare_regression_" + std::to_string(std::random_device{}()));
    fs::create_directories(path);
    write_picture(path / "lashes.png", test::lashed_pupil({256, 256, 5}, 4.5));
    write_picture(path / "lopsided.png", test::lopsided({240, 160, 6}));
    return path;
  }();
  return folder;
}

GlareTemplate made_by_command(const StoredTemplate& stored) {
  const fs::path output = working_folder() / (stored.name + ".exr");
  const std::string command = "cd '" + working_folder().string() +
                              "' && '" GLARE_PROGRAM "' template --quiet -o '" + output.string() +
                              "' " + stored.options;
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  if (std::getenv("GLARE_UPDATE_TEMPLATES") != nullptr)
    fs::copy_file(output, stored.file(), fs::copy_options::overwrite_existing);
  return read_template(output);
}

class Regression : public testing::TestWithParam<StoredTemplate> {};

TEST_P(Regression, MakesTheStoredPicture) {
  const GlareTemplate made = made_by_command(GetParam());
  ASSERT_TRUE(fs::exists(GetParam().file())) << "no stored template " << GetParam().file();
  const GlareTemplate stored = read_template(GetParam().file());
  ASSERT_EQ(made.width(), stored.width());
  ASSERT_EQ(made.height(), stored.height());
  EXPECT_NEAR(made.per_steradian / stored.per_steradian, 1, 1e-4);
  EXPECT_NEAR(made.captured_energy, stored.captured_energy, 1e-5);
  EXPECT_EQ(made.recipe, stored.recipe);
  double largest = 0, sum = 0;
  std::string where;
  for (int y = 0; y < made.height(); ++y)
    for (int x = 0; x < made.width(); ++x) {
      const double luminance = std::max(stored.luminance(x, y), 1e-12 * peak(stored).luminance);
      for (int k = 0; k < 3; ++k) {
        const double share =
            std::abs(made.channels[k](x, y) - stored.channels[k](x, y)) / luminance;
        sum += share;
        if (share <= largest) continue;
        largest = share;
        where =
            "channel " + std::to_string(k) + " at " + std::to_string(x) + ", " + std::to_string(y);
      }
    }
  EXPECT_LE(largest, kLargestDifference) << where;
  EXPECT_LE(sum / (3.0 * made.width() * made.height()), kMeanDifference);
}

INSTANTIATE_TEST_SUITE_P(Stored, Regression, testing::ValuesIn(stored_templates()),
                         [](const auto& test) { return test.param.name; });

TEST(Regression, EveryStoredFileHasACommand) {
  const auto templates = stored_templates();
  for (const auto& entry : fs::directory_iterator(kFolder / "templates"))
    EXPECT_TRUE(std::any_of(templates.begin(), templates.end(), [&](const StoredTemplate& stored) {
      return stored.file() == entry.path();
    })) << entry.path();
}

}  // namespace
}  // namespace glare
