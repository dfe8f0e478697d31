// Memory for working values, not set to anything. Internal.
#pragma once

#include <memory>
#include <span>

#include "glare/base/aligned_memory.h"

namespace glare {

/// So many values, always aligned alike: FFTW chooses its way by alignment too, and so every bit of
/// a result depends on it.
template <typename T>
class AlignedBuffer {
 public:
  explicit AlignedBuffer(std::size_t count)
      : data_(static_cast<T*>(allocate_aligned(count * sizeof(T))), Release{count}) {}

  std::span<T> values() { return {data_.get(), data_.get_deleter().count}; }

 private:
  struct Release {
    std::size_t count;
    void operator()(T* data) const { free_aligned(data, count * sizeof(T)); }
  };
  std::unique_ptr<T[], Release> data_;
};

/// Memory that is kept and grows as it is asked for more; what was in it is then lost.
template <typename T>
class GrowingBuffer {
 public:
  std::span<T> values(std::size_t count) {
    if (!buffer_ || buffer_->values().size() < count)
      buffer_ = std::make_unique<AlignedBuffer<T>>(count);
    return buffer_->values().first(count);
  }

 private:
  std::unique_ptr<AlignedBuffer<T>> buffer_;
};

}  // namespace glare
