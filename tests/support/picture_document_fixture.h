// What the tests of pictures among all else in their files share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "glare/base/error.h"
#include "glare/io/picture_document.h"
#include "support/image_file_fixture.h"

namespace glare::test {

class PictureDocumentTest : public ImageFileTest {
 protected:
  PictureDocument read(const std::filesystem::path& path, int part = -1,
                       const std::string& layer = "") const {
    return PictureDocument::read(path, {part, layer, kMemory});
  }
  PictureDocument document(const std::string& content, const std::string& layer = "") const {
    return read(put(content), -1, layer);
  }
  /// What is written for the document with each colour `gain` times as high.
  std::string written(const PictureDocument& document, float gain = 1,
                      const std::string& name = "out.exr") const {
    Picture changed = document.picture();
    for (Image<float>& channel : changed.channels)
      for (float& value : channel.values()) value *= gain;
    document.write(folder_ / name, changed);
    return content_of(folder_ / name);
  }
  /// Why the file is refused.
  std::string refused(const std::string& content, int part = -1,
                      const std::string& layer = "") const {
    try {
      read(put(content), part, layer);
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), (folder_ / "picture").string());
      return error.message();
    }
    return "nothing was refused";
  }
};

/// The file with the value of an attribute, given by its name and type with their zeros, replaced
/// by one as long.
inline std::string with(std::string file, const std::string& attribute, const std::string& value) {
  const std::size_t at = file.find(attribute);
  EXPECT_NE(at, std::string::npos);
  return file.replace(at + attribute.size() + 4, value.size(), value);
}

inline Values pixel(const Picture& picture, int x, int y) {
  return {picture.channels[0](x, y), picture.channels[1](x, y), picture.channels[2](x, y)};
}

}  // namespace glare::test
