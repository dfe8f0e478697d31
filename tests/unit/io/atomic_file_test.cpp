#include "glare/io/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

#include "glare/base/error.h"

namespace glare {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> bytes_of(const std::string& text) {
  std::vector<std::byte> bytes;
  for (const char character : text) bytes.push_back(static_cast<std::byte>(character));
  return bytes;
}

std::string text_of(const std::vector<std::byte>& bytes) {
  std::string text;
  for (const std::byte byte : bytes) text += static_cast<char>(byte);
  return text;
}

class AtomicFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "glare-atomic-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    old_umask_ = ::umask(022);
  }
  void TearDown() override {
    ::umask(old_umask_);
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }

  fs::path in_folder(const std::string& name) const { return folder_ / name; }
  void put(const fs::path& path, const std::string& text) const { std::ofstream(path) << text; }
  std::string get(const fs::path& path) const { return text_of(read_file(path, 1 << 20)); }
  int entries() const {
    return static_cast<int>(std::distance(fs::directory_iterator(folder_), {}));
  }
  static unsigned mode_of(const fs::path& path) {
    return static_cast<unsigned>(fs::status(path).permissions());
  }

  /// The message of the OutputError of writing to `path`, after checking that nothing was left.
  std::string refusal(const fs::path& path) const {
    const int before = entries();
    std::string early, late;
    try {
      require_writable(path);
    } catch (const OutputError& error) {
      early = error.what();
    }
    try {
      write_file_atomically(path, bytes_of("new"));
    } catch (const OutputError& error) {
      late = error.what();
    }
    EXPECT_EQ(early, late) << "the early check and the writing disagree";
    EXPECT_EQ(entries(), before);
    return late;
  }

  std::string read_refusal(const fs::path& path, std::uint64_t max_bytes = 100) const {
    try {
      read_file(path, max_bytes);
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), path.string());
      return error.what();
    }
    return "";
  }

  fs::path folder_;
  mode_t old_umask_ = 0;
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(AtomicFileTest, ReadsBackWhatItWrote) {
  std::string text;
  for (int i = 0; i < 9'000'000; ++i) text += static_cast<char>(i * 7 + i / 256);  // Three chunks.
  write_file_atomically(in_folder("a.exr"), bytes_of(text));
  EXPECT_TRUE(text_of(read_file(in_folder("a.exr"), text.size())) == text);
  write_file_atomically(in_folder("a.exr"), {});
  EXPECT_EQ(get(in_folder("a.exr")), "");
  EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicFileTest, ReadingRefusesWhatIsNotARegularFile) {
  ASSERT_EQ(::mkfifo(in_folder("pipe").c_str(), 0600), 0);
  EXPECT_TRUE(contains(read_refusal(in_folder("missing")), "no such file"));
  EXPECT_TRUE(contains(read_refusal(folder_), "is a folder"));
  EXPECT_TRUE(contains(read_refusal(in_folder("pipe")), "is a pipe"));
  EXPECT_TRUE(contains(read_refusal("/dev/zero"), "is a device"));
  EXPECT_TRUE(contains(read_refusal(in_folder("missing") / "a"), "no such file"));
  EXPECT_NE(read_refusal(""), "");
}

TEST_F(AtomicFileTest, ReadingObeysTheLimit) {
  put(in_folder("a"), std::string(100, 'x'));
  EXPECT_EQ(read_file(in_folder("a"), 100).size(), 100u);
  EXPECT_TRUE(contains(read_refusal(in_folder("a"), 99), "larger than the 99 bytes"));
}

TEST_F(AtomicFileTest, ReadingReportsAMissingPermission) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  put(in_folder("a"), "x");
  ::chmod(in_folder("a").c_str(), 0);
  EXPECT_TRUE(contains(read_refusal(in_folder("a")), "permission denied"));
}

TEST_F(AtomicFileTest, NewFilesFollowTheUmaskAndOldOnesKeepTheirMode) {
  ::umask(027);
  write_file_atomically(in_folder("new"), bytes_of("x"));
  EXPECT_EQ(mode_of(in_folder("new")), 0640u);
  put(in_folder("old"), "old");
  ::chmod(in_folder("old").c_str(), 0606);
  write_file_atomically(in_folder("old"), bytes_of("x"));
  EXPECT_EQ(mode_of(in_folder("old")), 0606u);
}

TEST_F(AtomicFileTest, CancellingLeavesTheOldFile) {
  put(in_folder("a"), "old");
  const std::vector<std::byte> content(9'000'000);  // Three chunks, so four questions.
  for (int allowed = 0; allowed < 4; ++allowed) {
    int asked = 0;
    const auto keep_going = [&] { return asked++ < allowed; };
    EXPECT_THROW(write_file_atomically(in_folder("a"), content, keep_going), Cancelled);
    EXPECT_EQ(asked, allowed + 1);
    EXPECT_EQ(get(in_folder("a")), "old");
    EXPECT_EQ(entries(), 1);
  }
}

TEST_F(AtomicFileTest, ThrowingCallbackLeavesNothing) {
  const auto keep_going = []() -> bool { throw std::runtime_error("from the callback"); };
  EXPECT_THROW(write_file_atomically(in_folder("a"), bytes_of("x"), keep_going),
               std::runtime_error);
  EXPECT_EQ(entries(), 0);
}

TEST_F(AtomicFileTest, TheTemporaryFileMatchesNoPictureGlob) {
  std::vector<std::string> names;
  const auto keep_going = [&] {
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename());
    }
    return true;
  };
  write_file_atomically(in_folder("a.exr"), bytes_of("x"), keep_going);
  ASSERT_FALSE(names.empty());
  for (const std::string& name : names) {
    EXPECT_EQ(name.rfind(".a.exr.glare-", 0), 0u) << name;
    EXPECT_NE(fs::path(name).extension(), ".exr") << name;
  }
}

TEST_F(AtomicFileTest, RefusesTargetsThatAreNotFiles) {
  ASSERT_EQ(::mkfifo(in_folder("pipe").c_str(), 0600), 0);
  fs::create_directory(in_folder("sub"));
  put(in_folder("file"), "old");
  EXPECT_TRUE(contains(refusal(in_folder("none") / "a.exr"), "the folder does not exist"));
  EXPECT_TRUE(contains(refusal(in_folder("none") / "a.exr"), in_folder("none").string()));
  EXPECT_TRUE(contains(refusal(in_folder("file") / "a.exr"), "not a folder"));
  EXPECT_TRUE(contains(refusal(in_folder("sub")), "is a folder"));
  EXPECT_TRUE(contains(refusal(in_folder("sub/")), "is a folder"));
  EXPECT_TRUE(contains(refusal(in_folder("sub") / ".."), "is a folder"));
  EXPECT_TRUE(contains(refusal(in_folder("pipe")), "is a pipe"));
  EXPECT_TRUE(contains(refusal("/dev/null"), "is a device"));
  EXPECT_TRUE(contains(refusal("/dev/full"), "is a device"));
  EXPECT_TRUE(contains(refusal("/dev/stdout"), "is a device"));
  EXPECT_TRUE(contains(refusal(""), "the file name is empty"));
  EXPECT_TRUE(contains(refusal(in_folder(std::string(256, 'a'))), "too long"));
  EXPECT_EQ(get(in_folder("file")), "old");
}

TEST_F(AtomicFileTest, LongestNamesCanBeWritten) {
  const fs::path path = in_folder(std::string(251, 'a') + ".exr");
  write_file_atomically(path, bytes_of("x"));
  EXPECT_EQ(get(path), "x");
}

TEST_F(AtomicFileTest, RefusesWhatIsProtected) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  put(in_folder("a"), "old");
  ::chmod(in_folder("a").c_str(), 0444);
  EXPECT_TRUE(contains(refusal(in_folder("a")), "the file is write-protected"));
  ::chmod(folder_.c_str(), 0555);
  EXPECT_TRUE(contains(refusal(in_folder("b")), "the folder is not writable"));
}

TEST_F(AtomicFileTest, SymbolicLinksStayAndTheirTargetsAreReplaced) {
  fs::create_directory(in_folder("sub"));
  put(in_folder("sub") / "real", "old");
  fs::create_symlink("sub/real", in_folder("link"));
  fs::create_symlink("sub/made", in_folder("dangling"));
  write_file_atomically(in_folder("link"), bytes_of("new"));
  write_file_atomically(in_folder("dangling"), bytes_of("made"));
  EXPECT_TRUE(fs::is_symlink(in_folder("link")));
  EXPECT_TRUE(fs::is_symlink(in_folder("dangling")));
  EXPECT_EQ(get(in_folder("sub") / "real"), "new");
  EXPECT_EQ(get(in_folder("sub") / "made"), "made");
}

TEST_F(AtomicFileTest, RefusesLinksThatGoRound) {
  fs::create_symlink("b", in_folder("a"));
  fs::create_symlink("a", in_folder("b"));
  EXPECT_TRUE(contains(refusal(in_folder("a")), "too many symbolic links"));
}

TEST_F(AtomicFileTest, WritesRelativeToTheCurrentFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  write_file_atomically("a", bytes_of("x"));
  fs::current_path(before);
  EXPECT_EQ(get(in_folder("a")), "x");
}

TEST_F(AtomicFileTest, PiecesGoWhereTheyBelongAndAppearAtOnce) {
  put(in_folder("a"), "old");
  {
    AtomicFile file(in_folder("a"));
    file.write_at(0, bytes_of("0123456789"));
    file.write_at(4, bytes_of("abc"));
    file.write_at(12, bytes_of("end"));
    EXPECT_EQ(get(in_folder("a")), "old");
    file.commit();
    EXPECT_EQ(get(in_folder("a")), std::string("0123abc789\0\0end", 15));
  }
  EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicFileTest, PiecesWithoutACommitLeaveNothing) {
  put(in_folder("a"), "old");
  { AtomicFile(in_folder("a")).write_at(0, bytes_of("new")); }
  {
    AtomicFile file(in_folder("a"));
    file.write_at(0, bytes_of("new"));
    EXPECT_THROW(file.commit([] { return false; }), Cancelled);
  }
  EXPECT_EQ(get(in_folder("a")), "old");
  EXPECT_EQ(entries(), 1);
}

TEST_F(AtomicFileTest, AFileSizeLimitIsAnErrorAndLeavesTheOldFile) {
  put(in_folder("a"), "old");
  struct rlimit old_limit {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  struct rlimit limit = old_limit;
  limit.rlim_cur = 1 << 16;
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::string message;
  try {
    write_file_atomically(in_folder("a"), std::vector<std::byte>(1 << 17));
  } catch (const OutputError& error) {
    message = error.what();
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_TRUE(contains(message, "larger than files may be")) << message;
  EXPECT_EQ(get(in_folder("a")), "old");
  EXPECT_EQ(entries(), 1);
}

}  // namespace
}  // namespace glare
