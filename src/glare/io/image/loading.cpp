#include "glare/io/image/loading.h"

#include <system_error>

#include "glare/io/atomic_file.h"

namespace glare::image_io {

Bytes read_limited(const std::filesystem::path& path, std::uint64_t max_bytes) {
  std::error_code error;
  const bool regular = std::filesystem::is_regular_file(path, error);
  const std::uint64_t size = regular ? std::filesystem::file_size(path, error) : 0;
  if (!error && size > max_bytes) throw MemoryError(size, max_bytes);
  return read_file(path, max_bytes);
}

CheckedPixels decoded_within(const Format& format, Bytes& bytes, std::uint64_t max_bytes,
                             std::uint64_t result_channels) try {
  const Header header = format.checked(bytes);
  require_fits(header, bytes.size(), max_bytes, result_channels);
  return {header, decoded(format, header, bytes)};
} catch (const BadImage& bad) {
  throw BadImage(std::string(bad.what()) + " (" + format.name + ")");
}

}  // namespace glare::image_io
