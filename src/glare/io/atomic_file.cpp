#include "glare/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "glare/base/error.h"

namespace glare {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChunkBytes = std::size_t{4} << 20;
constexpr int kMaxLinks = 40;
constexpr std::size_t kMaxTemporaryStem = 200;  // Of the 255 bytes that a file name may have.

/// An open file descriptor, closed when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }
  bool valid() const { return fd_ >= 0; }
  /// Closes now, and says whether that went well: some file systems report a full disk only then.
  bool close() { return ::close(std::exchange(fd_, -1)) == 0 || errno == EINTR; }

 private:
  int fd_;
};

std::string error_text(int error_number) {
  switch (error_number) {
    case ENOENT:
      return "no such file";
    case EACCES:
    case EPERM:
      return "permission denied";
    case EISDIR:
      return "is a folder";
    case ENOSPC:
      return "no space left on the device";
    case EDQUOT:
      return "the disk quota is used up";
    case EFBIG:
      return "would be larger than files may be here";
    case EROFS:
      return "the file system is read-only";
    case ENAMETOOLONG:
      return "the file name is too long";
    case ELOOP:
      return "too many symbolic links";
    case ENOTDIR:
      return "a part of the path is not a folder";
    default:
      return std::generic_category().message(error_number);
  }
}

/// What kind of thing a file is that is not a regular file.
std::string kind_text(mode_t mode) {
  if (S_ISDIR(mode)) return "is a folder";
  if (S_ISFIFO(mode)) return "is a pipe, not a regular file";
  if (S_ISSOCK(mode)) return "is a socket, not a regular file";
  return "is a device, not a regular file";
}

// Reading.

Descriptor opened_for_reading(const fs::path& path) {
  // Without O_NONBLOCK, opening a pipe would wait for a writer.
  int fd = -1;
  do {
    fd = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  } while (fd < 0 && errno == EINTR);
  if (fd >= 0) return Descriptor(fd);
  const int reason = errno;
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode))
    throw InputError(path.string(), kind_text(status.st_mode));
  throw InputError(path.string(), error_text(reason));
}

void require_not_above(const fs::path& path, std::uint64_t size, std::uint64_t max_bytes) {
  if (size <= max_bytes) return;
  throw InputError(path.string(),
                   "the file is larger than the " + std::to_string(max_bytes) + " bytes allowed");
}

std::size_t read_some(const fs::path& path, int fd, std::span<std::byte> into) {
  while (true) {
    const ssize_t count = ::read(fd, into.data(), into.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) throw InputError(path.string(), error_text(errno));
  }
}

// Writing.

/// Where the bytes are to go: the place that the caller named, with its symbolic links followed.
struct Target {
  fs::path path;
  fs::path folder;
  std::optional<mode_t> old_mode;  ///< Permissions of the file to be replaced, if there is one.
};

[[noreturn]] void fail(const fs::path& place, const std::string& message) {
  throw OutputError(place.string(), message);
}

bool is_symbolic_link(const fs::path& place, const fs::path& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) == 0) return S_ISLNK(status.st_mode);
  if (errno == ENOENT || errno == ENOTDIR || errno == EACCES) return false;
  fail(place, error_text(errno));
}

/// The file that `place` stands for. A link that points to nothing gives the name it points to.
fs::path link_followed(const fs::path& place) {
  fs::path path = place;
  for (int i = 0; is_symbolic_link(place, path); ++i) {
    if (i == kMaxLinks) fail(place, error_text(ELOOP));
    // /dev/stdout leads here; where it would lead on is the file behind a redirection.
    if (path.native().starts_with("/proc/")) fail(place, kind_text(S_IFCHR));
    std::error_code error;
    const fs::path next = fs::read_symlink(path, error);
    if (error) fail(place, error_text(error.value()));
    path = path.parent_path() / next;
  }
  return path;
}

void require_folder(const fs::path& place, const fs::path& folder) {
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) {
    fail(place, errno == ENOENT ? "the folder does not exist" : error_text(errno));
  }
  if (!S_ISDIR(status.st_mode)) fail(place, folder.string() + " is not a folder");
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) == 0) return;
  fail(place, errno == EACCES ? "the folder is not writable" : error_text(errno));
}

/// Permissions of the regular file at `path`; nothing if there is no file.
std::optional<mode_t> mode_of_old_file(const fs::path& place, const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno == ENOENT) return std::nullopt;
    fail(place, error_text(errno));
  }
  if (!S_ISREG(status.st_mode)) fail(place, kind_text(status.st_mode));
  if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
    fail(place, errno == EACCES ? "the file is write-protected" : error_text(errno));
  }
  return status.st_mode & mode_t{0777};
}

Target target_of(const fs::path& place) {
  if (place.empty()) fail("output", "the file name is empty");
  if (place.native().find('\0') != std::string::npos) fail("output", "the file name is damaged");
  Target target;
  target.path = link_followed(place);
  const fs::path parent = target.path.parent_path();
  target.folder = parent.empty() ? fs::path(".") : parent;
  const fs::path name = target.path.filename();
  target.old_mode = mode_of_old_file(place, target.path);
  require_folder(place, target.folder);
  if (name.empty() || name == "." || name == "..") fail(place, "is a folder");
  return target;
}

/// The temporary file beside the target. It removes itself unless it has been renamed.
class TemporaryFile {
 public:
  TemporaryFile(const fs::path& place, const Target& target)
      : place_(place), path_(), descriptor_(created(target)) {
    if (!descriptor_.valid()) fail(place, error_text(errno));
    if (target.old_mode && ::fchmod(descriptor_.get(), *target.old_mode) != 0) {
      const int reason = errno;
      ::unlink(path_.c_str());  // The destructor does not run when a constructor throws.
      fail(place, error_text(reason));
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!renamed_) ::unlink(path_.c_str());
  }

  void write_at(std::uint64_t position, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t count =
          ::pwrite(descriptor_.get(), bytes.data(), bytes.size(), static_cast<off_t>(position));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail(place_, error_text(errno));
      if (count == 0) fail(place_, error_text(ENOSPC));
      position += static_cast<std::uint64_t>(count);
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }

  /// Brings the content to the disk and closes the file.
  void finish() {
    int result = 0;
    do {
      result = ::fsync(descriptor_.get());
    } while (result != 0 && errno == EINTR);
    if (result != 0 && errno != EINVAL)
      fail(place_, error_text(errno));  // EINVAL: can't be synced.
    if (!descriptor_.close()) fail(place_, error_text(errno));
  }

  void rename_to(const fs::path& path) {
    if (::rename(path_.c_str(), path.c_str()) != 0) fail(place_, error_text(errno));
    renamed_ = true;
  }

 private:
  /// Creates the file with a name of its own. O_CREAT with 0666 leaves the umask to the system:
  /// to ask for it, as mkstemp and fchmod would need, is to change it for every thread.
  int created(const Target& target) {
    static std::atomic<unsigned> counter{0};
    std::string stem = ".";
    stem.append(target.path.filename().native(), 0, kMaxTemporaryStem).append(".glare-");
    for (int attempt = 0; attempt < 1000; ++attempt) {
      path_ = target.folder / (stem + std::to_string(::getpid()) + "-" + std::to_string(counter++));
      const int fd = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (fd >= 0 || (errno != EEXIST && errno != EINTR)) return fd;
    }
    return -1;
  }

  const fs::path& place_;
  fs::path path_;
  Descriptor descriptor_;
  bool renamed_ = false;
};

void require_going(const std::function<bool()>& keep_going) {
  if (keep_going && !keep_going()) throw Cancelled();
}

/// Brings the renaming to the disk. A failure is not reported: the file is complete and in place.
void sync_folder(const fs::path& folder) {
  const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.valid()) ::fsync(descriptor.get());
}

}  // namespace

std::vector<std::byte> read_file(const fs::path& path, std::uint64_t max_bytes) {
  const Descriptor file = opened_for_reading(path);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) throw InputError(path.string(), error_text(errno));
  if (!S_ISREG(status.st_mode)) throw InputError(path.string(), kind_text(status.st_mode));
  const auto size = static_cast<std::uint64_t>(status.st_size);
  require_not_above(path, size, max_bytes);
  // One byte more than the size, so that a file that does not grow is read in one go.
  std::vector<std::byte> content(static_cast<std::size_t>(size) + 1);
  std::size_t filled = 0;
  while (const std::size_t count =
             read_some(path, file.get(), std::span(content).subspan(filled))) {
    filled += count;
    require_not_above(path, filled, max_bytes);
    if (filled == content.size()) content.resize(filled + kChunkBytes);
  }
  content.resize(filled);
  return content;
}

struct AtomicFile::Parts {
  explicit Parts(const fs::path& path)
      : place(path), target(target_of(place)), temporary(place, target) {}

  fs::path place;
  Target target;
  TemporaryFile temporary;
};

AtomicFile::AtomicFile(const fs::path& path) : parts_(std::make_unique<Parts>(path)) {}

AtomicFile::~AtomicFile() = default;

void AtomicFile::write_at(std::uint64_t position, std::span<const std::byte> bytes) {
  parts_->temporary.write_at(position, bytes);
}

void AtomicFile::commit(const std::function<bool()>& keep_going) {
  parts_->temporary.finish();
  require_going(keep_going);
  parts_->temporary.rename_to(parts_->target.path);
  sync_folder(parts_->target.folder);
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> content,
                           const std::function<bool()>& keep_going) {
  AtomicFile file(path);
  for (std::size_t position = 0; position < content.size(); position += kChunkBytes) {
    require_going(keep_going);
    file.write_at(position,
                  content.subspan(position, std::min(content.size() - position, kChunkBytes)));
  }
  file.commit(keep_going);
}

void require_writable(const fs::path& path) { target_of(path); }

}  // namespace glare
