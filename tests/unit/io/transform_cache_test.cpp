#include "glare/io/transform_cache.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "glare/diffraction/transform_plans.h"

namespace glare {
namespace {

namespace fs = std::filesystem;

/// The plans come in any order.
std::set<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::set<std::string> result;
  for (std::string line; std::getline(stream, line);) result.insert(line);
  return result;
}

/// Plans that only this file knows, in a folder of the test's own.
class TransformCache : public testing::Test {
 protected:
  TransformCache() {
    std::string name = (fs::temp_directory_path() / "glare_cache_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    path_ = folder_ / "a" / "transforms";
    forget_transform_plans();
    measure_transforms(std::array{96});
    plans_ = transform_plans_text();
    stored_ = store_transform_plans(path_);
    forget_transform_plans();
    nothing_ = transform_plans_text();
  }
  ~TransformCache() override {
    forget_transform_plans();
    fs::remove_all(folder_);
  }

  std::string content() const {
    std::ostringstream text;
    text << std::ifstream(path_, std::ios::binary).rdbuf();
    return text.str();
  }
  void write(const std::string& content) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << content;
  }
  void expect_refused(const std::string& content) const {
    write(content);
    EXPECT_FALSE(load_transform_plans(path_));
    EXPECT_EQ(transform_plans_text(), nothing_);
  }
  std::string replaced(const std::string& from, const std::string& to) const {
    std::string text = content();
    return text.replace(text.find(from), from.size(), to);
  }

  fs::path folder_, path_;
  std::string plans_, nothing_;
  bool stored_ = false;
};

TEST_F(TransformCache, GivesBackThePlans) {
  ASSERT_TRUE(stored_);
  ASSERT_NE(plans_, nothing_);
  EXPECT_TRUE(load_transform_plans(path_));
  EXPECT_EQ(lines(transform_plans_text()), lines(plans_));
}

TEST_F(TransformCache, MakesItsFolderForTheUserAlone) {
  struct stat status {};
  ASSERT_EQ(::stat(path_.parent_path().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0700u);
}

TEST_F(TransformCache, RefusesAFileDamagedAnywhere) {
  const std::string good = content();
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 1);
    expect_refused(bad);
  }
  write(good);
  EXPECT_TRUE(load_transform_plans(path_));
}

TEST_F(TransformCache, RefusesATruncatedOrLongerFile) {
  const std::string good = content();
  for (std::size_t size = 0; size < good.size(); ++size) expect_refused(good.substr(0, size));
  expect_refused(good + "\n");
  expect_refused(good + good);
  expect_refused(good + std::string(2 << 20, 'x'));
}

TEST_F(TransformCache, RefusesAnotherVersion) { expect_refused(replaced("plans 1", "plans 2")); }

TEST_F(TransformCache, RefusesAnotherLibrary) {
  expect_refused(replaced(transform_library(), "fftw-3.9.9"));
}

TEST_F(TransformCache, RefusesAnotherProcessor) {
  const std::string good = content();
  const std::size_t digits = good.find("processor ") + 10;
  expect_refused(std::string(good).replace(digits, 64, std::string(64, '0')));
}

TEST_F(TransformCache, IsReplacedWhereItWasDamaged) {
  write("nonsense");
  EXPECT_FALSE(load_transform_plans(path_));
  measure_transforms(std::array{96});
  EXPECT_TRUE(store_transform_plans(path_));
  forget_transform_plans();
  EXPECT_TRUE(load_transform_plans(path_));
}

TEST_F(TransformCache, DoesWithoutAFile) {
  EXPECT_FALSE(load_transform_plans(folder_ / "no" / "such"));
  EXPECT_FALSE(load_transform_plans(folder_));
  EXPECT_FALSE(load_transform_plans({}));
  EXPECT_FALSE(load_transform_plans("/dev/zero"));
}

TEST_F(TransformCache, TellsWhereItCannotBeWritten) {
  EXPECT_FALSE(store_transform_plans({}));
  EXPECT_FALSE(store_transform_plans(folder_));
  EXPECT_FALSE(store_transform_plans(path_ / "below a file"));
  EXPECT_FALSE(store_transform_plans("/proc/glare/transforms"));
}

TEST_F(TransformCache, TellsAFolderThatIsReadOnly) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_FALSE(store_transform_plans(folder_ / "b" / "transforms"));
  EXPECT_FALSE(store_transform_plans(folder_ / "transforms"));
  fs::permissions(folder_, fs::perms::owner_all);
}

TEST_F(TransformCache, IsWholeWhileSeveralProcessesWriteIt) {
  ASSERT_TRUE(load_transform_plans(path_));
  std::array<pid_t, 2> writers;
  for (pid_t& writer : writers) {
    writer = ::fork();
    if (writer != 0) continue;
    bool all = true;
    for (int i = 0; i < 50; ++i) all = store_transform_plans(path_) && all;
    ::_exit(all ? 0 : 1);
  }
  for (int i = 0; i < 200; ++i) EXPECT_TRUE(load_transform_plans(path_));
  for (const pid_t writer : writers) {
    int status = -1;
    ::waitpid(writer, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(lines(transform_plans_text()), lines(plans_));
  EXPECT_EQ(std::distance(fs::directory_iterator(path_.parent_path()), {}), 1);
}

TEST(TransformPlansPath, IsInTheUsersCacheFolder) {
  const auto with = [](const char* cache, const char* home) {
    const auto set = [](const char* name, const char* value) {
      value ? ::setenv(name, value, 1) : ::unsetenv(name);
    };
    const char* const old_home = std::getenv("HOME");
    const std::string kept = old_home ? old_home : "";
    set("XDG_CACHE_HOME", cache);
    set("HOME", home);
    const fs::path path = transform_plans_path();
    set("XDG_CACHE_HOME", nullptr);
    set("HOME", old_home ? kept.c_str() : nullptr);
    return path.string();
  };
  EXPECT_EQ(with("/c", "/h"), "/c/glare/transforms");
  EXPECT_EQ(with(nullptr, "/h"), "/h/.cache/glare/transforms");
  EXPECT_EQ(with("", "/h"), "/h/.cache/glare/transforms");
  EXPECT_EQ(with("relative", "/h"), "/h/.cache/glare/transforms");
  EXPECT_EQ(with(nullptr, nullptr), "");
}

}  // namespace
}  // namespace glare
