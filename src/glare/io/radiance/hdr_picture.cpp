#include "glare/io/radiance/hdr_picture.h"

#include <string>

#include "glare/io/atomic_file.h"
#include "glare/io/image/decoder.h"
#include "glare/io/image/format.h"
#include "glare/io/image/loading.h"
#include "glare/io/radiance/rgbe_pixels.h"

namespace glare::radiance_io {

using image_io::Bytes;

HdrPicture read_hdr_picture(Bytes file, std::uint64_t max_bytes) {
  HdrPicture read;
  read.header = hdr_header(file);
  call_rgbe(file);
  const auto [header, pixels] =
      image_io::decoded_within(image_io::recognized_format(file), file, max_bytes, 3);
  image_io::require(pixels.channels == 3, "has other channels than three");
  read.picture.color_space = read.header.color_space;
  for (int k = 0; k < 3; ++k) {
    Image<float>& channel = read.picture.channels[static_cast<std::size_t>(k)];
    channel = Image<float>(pixels.width, pixels.height);
    for (int y = 0; y < pixels.height; ++y)
      for (int x = 0; x < pixels.width; ++x) channel(x, y) = pixels(x, y, k);
  }
  return read;
}

std::uint64_t write_hdr_picture(const std::filesystem::path& path, const HdrHeader& header,
                                const Picture& picture, const std::function<bool()>& keep_going) {
  std::string text;
  for (const std::string& line : header.lines) text += line + "\n";
  text +=
      "\n-Y " + std::to_string(picture.height()) + " +X " + std::to_string(picture.width()) + "\n";
  std::uint64_t limited = 0;
  Bytes file;
  image_io::append(file, text);
  image_io::append(file, rgbe_rows(picture, limited));
  write_file_atomically(path, file, keep_going);
  return limited;
}

}  // namespace glare::radiance_io
