#include "glare/io/openexr/memory_stream.h"

#include <OpenEXR/ImfThreading.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <utility>

#include "glare/base/error.h"
#include "glare/base/parallel.h"

namespace glare::openexr_io {

void MemoryOutput::write(const char* data, int count) {
  const auto size = static_cast<std::size_t>(count);
  const auto* const first = reinterpret_cast<const std::byte*>(data);
  if (position_ == bytes_.size()) {
    bytes_.insert(bytes_.end(), first, first + size);
  } else {
    bytes_.resize(std::max(bytes_.size(), position_ + size));
    std::memcpy(bytes_.data() + position_, data, size);
  }
  position_ += size;
}

MemoryInput::MemoryInput(const std::string& name, std::vector<std::byte> bytes)
    : Imf::IStream(name.c_str()), bytes_(std::move(bytes)) {}

bool MemoryInput::read(char* data, int count) {
  const auto size = static_cast<std::size_t>(count);
  if (count < 0 || size > bytes_.size() - std::min(position_, bytes_.size()))
    throw InputError("", "ends too early");
  std::memcpy(data, bytes_.data() + position_, size);
  position_ += size;
  return position_ < bytes_.size();
}

namespace {

/// Who has grown OpenEXR's pool of threads.
struct PoolUse {
  std::mutex mutex;
  int users = 0;
  int threads_before = 0;
};

PoolUse& pool_use() {
  static PoolUse use;
  return use;
}

}  // namespace

CompressionThreads::CompressionThreads(int threads) {
  count_ = threads_used(threads);
  PoolUse& use = pool_use();
  const std::scoped_lock lock(use.mutex);
  if (use.users == 0) use.threads_before = Imf::globalThreadCount();
  if (Imf::globalThreadCount() < count_) Imf::setGlobalThreadCount(count_);
  ++use.users;
}

CompressionThreads::~CompressionThreads() {
  PoolUse& use = pool_use();
  const std::scoped_lock lock(use.mutex);
  if (--use.users == 0 && Imf::globalThreadCount() != use.threads_before)
    Imf::setGlobalThreadCount(use.threads_before);
}

}  // namespace glare::openexr_io
