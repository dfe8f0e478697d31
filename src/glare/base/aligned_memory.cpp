#include "glare/base/aligned_memory.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace glare {

namespace {

constexpr std::size_t kCacheLine = 64, kLargePage = std::size_t{2} << 20;

bool is_large(std::size_t bytes) { return bytes >= kLargePage; }

std::align_val_t alignment(std::size_t bytes) {
  return std::align_val_t{is_large(bytes) ? kLargePage : kCacheLine};
}

}  // namespace

void* allocate_aligned(std::size_t bytes) {
  void* const memory = ::operator new(bytes, alignment(bytes));
#if defined(__linux__)
  if (is_large(bytes)) madvise(memory, bytes, MADV_HUGEPAGE);  // A wish: it may well be refused.
#endif
  return memory;
}

void free_aligned(void* memory, std::size_t bytes) noexcept {
  ::operator delete(memory, alignment(bytes));
}

}  // namespace glare
