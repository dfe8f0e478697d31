// OpenEXR's way to a file that appears all at once. Internal.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "glare/io/atomic_file.h"

namespace glare::openexr_io {

/// Writes what OpenEXR writes to a file, through a small buffer.
class FileOutput : public Imf::OStream {
 public:
  explicit FileOutput(AtomicFile& file);

  void write(const char* data, int count) override;
  std::uint64_t tellp() override { return buffer_begin_ + buffer_.size(); }
  void seekp(std::uint64_t position) override;

  /// Writes what is left in the buffer, once OpenEXR has let go of the file. Throws what any
  /// earlier writing threw: OpenEXR keeps silent about what fails when it closes a file.
  void finish();

 private:
  void write_to_file(std::span<const std::byte> bytes);
  void flush();

  AtomicFile& file_;
  std::uint64_t buffer_begin_ = 0;  ///< Where in the file the buffer belongs.
  std::vector<std::byte> buffer_;
  std::exception_ptr failure_;
};

/// Writes what `encode` gives the stream to a file at `path`, all or nothing. Throws `OutputError`,
/// also for what OpenEXR throws; `Cancelled` where `keep_going` says false at the end.
void write_openexr_file(const std::filesystem::path& path, const std::function<bool()>& keep_going,
                        const std::function<void(Imf::OStream&)>& encode);

}  // namespace glare::openexr_io
