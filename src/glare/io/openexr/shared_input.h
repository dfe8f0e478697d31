// An OpenEXR file in memory that several readers share. Internal.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

#include "glare/io/image/byte_reader.h"

namespace glare::openexr_io {

class SharedInput : public Imf::IStream {
 public:
  explicit SharedInput(std::shared_ptr<const image_io::Bytes> bytes)
      : Imf::IStream("file"), bytes_(std::move(bytes)) {}

  bool read(char* data, int count) override {
    const std::uint64_t size = bytes_->size();
    const std::uint64_t left = size - std::min(position_, size);
    image_io::require(count >= 0 && static_cast<std::uint64_t>(count) <= left,
                      "the file is cut short");
    std::memcpy(data, bytes_->data() + position_, static_cast<std::size_t>(count));
    position_ += static_cast<std::uint64_t>(count);
    return position_ < size;
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::shared_ptr<const image_io::Bytes> bytes_;
  std::uint64_t position_ = 0;
};

}  // namespace glare::openexr_io
