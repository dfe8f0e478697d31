// Whole files to memory and back: reading with a limit, writing all or nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace glare {

/// The whole content of the regular file at `path` (symbolic links are followed). Throws
/// `InputError`, whose place is `path`, where there is no such file, it can't be read, it is a
/// folder, a device, a pipe or a socket (none of which is waited for), or it is larger than
/// `max_bytes`.
std::vector<std::byte> read_file(const std::filesystem::path& path, std::uint64_t max_bytes);

/// A file that appears all at once, when it is complete. It is written to a hidden temporary file
/// in the same folder (`.NAME.glare-...`, which no `*.exr` or `*.png` matches); `commit` brings
/// that to the disk and renames it. Whatever was at `path` before stays as it was until then; its
/// permissions are kept. A new file gets those of the umask. A symbolic link stays, and what it
/// points to is replaced. Without a commit the temporary file is removed.
///
/// All throw `OutputError`, whose place is `path`, under the conditions of `require_writable` and
/// where the disk is full or fails. A process that runs under a limit of the file size must ignore
/// SIGXFSZ, as the program `glare` does, to see that as such an error: otherwise the signal ends
/// the process. The library itself changes no signal's handling.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Writes bytes from a position in the file on.
  void write_at(std::uint64_t position, std::span<const std::byte> bytes);

  /// Puts the file in its place, once. `keep_going`, where not empty, is asked just before the
  /// renaming; when it says false `Cancelled` is thrown.
  void commit(const std::function<bool()>& keep_going = {});

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Makes `content` the content of the file at `path`, all or nothing, as an `AtomicFile`.
/// `keep_going`, where not empty, is asked now and then, the last time just before the renaming;
/// when it says false `Cancelled` is thrown.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> content,
                           const std::function<bool()>& keep_going = {});

/// Throws `OutputError`, whose place is `path`, where a file of that name can't be written: the
/// folder does not exist, is not a folder or is not writable, or `path` is a folder, a device, a
/// pipe, or a write-protected file. A cheap check before long work; it changes nothing on the disk.
void require_writable(const std::filesystem::path& path);

}  // namespace glare
