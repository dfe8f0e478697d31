// OpenEXR files in memory, and OpenEXR's threads. Internal.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace glare::openexr_io {

/// A file in memory, written by OpenEXR.
class MemoryOutput : public Imf::OStream {
 public:
  MemoryOutput() : Imf::OStream("memory") {}

  void write(const char* data, int count) override;
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::size_t size() const { return bytes_.size(); }
  /// The file, once OpenEXR has let go of it.
  std::vector<std::byte> take_bytes() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
  std::size_t position_ = 0;
};

/// A file in memory, read by OpenEXR.
class MemoryInput : public Imf::IStream {
 public:
  MemoryInput(const std::string& name, std::vector<std::byte> bytes);

  bool read(char* data, int count) override;
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::vector<std::byte> bytes_;
  std::size_t position_ = 0;
};

/// OpenEXR compresses in one pool of threads that the whole process shares. While there are objects
/// of this class the pool has at least as many as each of them asked for; then it is as before.
class CompressionThreads {
 public:
  /// `threads`: at most as many as the machine has; 0: just as many.
  explicit CompressionThreads(int threads);
  ~CompressionThreads();
  CompressionThreads(const CompressionThreads&) = delete;
  CompressionThreads& operator=(const CompressionThreads&) = delete;

  int count() const { return count_; }

 private:
  int count_;
};

}  // namespace glare::openexr_io
