// A picture in memory: a rectangle of values, row by row from the top, left to right.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "glare/base/aligned_memory.h"

namespace glare {

template <typename T>
class Image {
 public:
  Image() = default;
  /// A `width` x `height` picture of `fill`. Both sizes are at least 0.
  Image(int width, int height, T fill = T{})
      : width_(width),
        height_(height),
        values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {
    assert(width >= 0 && height >= 0);
  }

  /// One whose values are not set to anything, for those who set them all.
  static Image uninitialized(int width, int height) {
    Image image;
    image.width_ = width;
    image.height_ = height;
    image.values_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    return image;
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return values_.empty(); }

  T& operator()(int x, int y) { return values_[index(x, y)]; }
  const T& operator()(int x, int y) const { return values_[index(x, y)]; }

  std::span<T> row(int y) { return values().subspan(row_start(y), row_length()); }
  std::span<const T> row(int y) const { return values().subspan(row_start(y), row_length()); }
  std::span<T> values() { return values_; }
  std::span<const T> values() const { return values_; }

 private:
  std::size_t row_length() const { return static_cast<std::size_t>(width_); }
  std::size_t row_start(int y) const {
    assert(y >= 0 && y < height_);
    return static_cast<std::size_t>(y) * row_length();
  }
  std::size_t index(int x, int y) const {
    assert(x >= 0 && x < width_);
    return row_start(y) + static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<T, AlignedAllocator<T>> values_;
};

}  // namespace glare
