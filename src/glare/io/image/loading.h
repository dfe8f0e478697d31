// From a picture's file to its pixels: the steps that all its readers share. Internal.
#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include "glare/base/error.h"
#include "glare/io/image/decoder.h"
#include "glare/io/image/format.h"
#include "glare/io/image/image_header.h"

namespace glare::image_io {

/// The file at `path`. Throws `MemoryError` where it is larger than `max_bytes`.
Bytes read_limited(const std::filesystem::path& path, std::uint64_t max_bytes);

struct CheckedPixels {
  Header header;
  Pixels pixels;
};

/// The pixels of a file of this format, checked before they are decoded; `bytes` is left as the
/// check leaves it. A picture of `result_channels` floats is to be made of them. Throws `BadImage`,
/// with the format's name; `MemoryError`.
CheckedPixels decoded_within(const Format& format, Bytes& bytes, std::uint64_t max_bytes,
                             std::uint64_t result_channels);

/// What `read(bytes, max_bytes)` makes of the file's bytes, with every exception as a public one.
template <typename Read>
auto read_with(const std::filesystem::path& path, std::uint64_t max_bytes, const Read& read) {
  const std::string place = path.string();
  try {
    return read(read_limited(path, max_bytes), max_bytes);
  } catch (const BadImage& bad) {
    throw InputError(place, bad.what());
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw MemoryError(max_bytes, max_bytes);
  } catch (const std::exception& error) {
    throw InputError(place, "the data are damaged: " + one_line(error.what()));
  }
}

}  // namespace glare::image_io
