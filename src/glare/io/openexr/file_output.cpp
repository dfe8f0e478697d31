#include "glare/io/openexr/file_output.h"

#include <new>
#include <string>

#include "glare/base/error.h"

namespace glare::openexr_io {

namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;

}  // namespace

FileOutput::FileOutput(AtomicFile& file) : Imf::OStream("file"), file_(file) {
  buffer_.reserve(kBufferBytes);
}

void FileOutput::write(const char* data, int count) {
  const std::span bytes(reinterpret_cast<const std::byte*>(data), static_cast<std::size_t>(count));
  if (buffer_.size() + bytes.size() > kBufferBytes) flush();
  if (bytes.size() > kBufferBytes)
    write_to_file(bytes);
  else
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

void FileOutput::seekp(std::uint64_t position) {
  flush();
  buffer_begin_ = position;
}

void FileOutput::finish() { flush(); }

void FileOutput::flush() {
  write_to_file(buffer_);
  buffer_.clear();
}

void FileOutput::write_to_file(std::span<const std::byte> bytes) {
  if (failure_) std::rethrow_exception(failure_);
  try {
    file_.write_at(buffer_begin_, bytes);
  } catch (...) {
    failure_ = std::current_exception();
    throw;
  }
  buffer_begin_ += bytes.size();
}

void write_openexr_file(const std::filesystem::path& path, const std::function<bool()>& keep_going,
                        const std::function<void(Imf::OStream&)>& encode) {
  AtomicFile file(path);
  try {
    FileOutput output(file);
    encode(output);
    output.finish();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw OutputError(path.string(), std::string("can't be encoded: ") + error.what());
  }
  file.commit(keep_going);
}

}  // namespace glare::openexr_io
