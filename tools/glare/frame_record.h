// Which frames of a sequence are finished: a file beside them, for --resume.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>

namespace glare::tool {

/// Lines of JSON: a first one that says what it is, then {"frame", "key", "sha256"} of each frame
/// that was finished: `key` is the fingerprint of all that the frame is made from, `sha256` its
/// file's. A frame is trusted only where both are as they should be. A line that was cut short
/// counts for nothing.
class FrameRecord {
 public:
  /// Of the frames of a name with {frame} in it: beside them, with "frames" in that place and
  /// ".glare-frames" after it.
  explicit FrameRecord(const std::string& pattern);

  const std::filesystem::path& file() const { return file_; }

  /// Throws `OutputError` where the file is there and is no record, or can't be written.
  void require_writable() const;

  /// Begins anew or, to resume, with what the file has of so many frames. Throws `OutputError`.
  void begin(bool resume, int frames);

  /// True where the frame was finished from the same `key`, and its file is as it was then.
  bool is_finished(int frame, const std::string& key, const std::filesystem::path& file) const;

  /// Notes a frame whose file is in its place. May be called by several threads. Throws
  /// `OutputError`.
  void add(int frame, const std::string& key, const std::string& sha256);

  /// Writes the record in the order of the frames. Throws `OutputError`.
  void finish() const;

 private:
  struct Entry {
    std::string key, sha256;
  };
  std::string line_of(int frame, const Entry& entry) const;
  void read(int frames);

  std::filesystem::path file_;
  mutable std::mutex mutex_;
  std::map<int, Entry> entries_;
};

/// Takes away what a killed process has left beside the frames: temporary files, .NAME.glare-PID-N
/// (see `AtomicFile`), of processes that are no more. `names` are the frames' files in `folder`.
void remove_leftovers(std::set<std::string> names, const std::filesystem::path& folder,
                      const FrameRecord& record);

}  // namespace glare::tool
