#include "glare/c/c_errors.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>

#include "glare/io/memory.h"

namespace glare::c {

namespace {

/// Cut, where it must be, before a character of UTF-8 rather than in it.
std::size_t cut_length(const char* text, std::size_t length, std::size_t most) {
  if (length <= most) return length;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return most;
}

glare_status tell(glare_error* error, glare_status status, const char* message) noexcept {
  if (error == nullptr) return status;
  error->status = status;
  const std::size_t length = cut_length(message, std::strlen(message), sizeof error->message - 1);
  std::memcpy(error->message, message, length);
  error->message[length] = '\0';
  return status;
}

}  // namespace

glare_status told(const std::exception_ptr& thrown, glare_error* error) noexcept {
  try {
    std::rethrow_exception(thrown);
  } catch (const OptionError& e) {
    return tell(error, GLARE_ERROR_OPTION, e.what());
  } catch (const InputError& e) {
    return tell(error, GLARE_ERROR_INPUT, e.what());
  } catch (const OutputError& e) {
    return tell(error, GLARE_ERROR_OUTPUT, e.what());
  } catch (const MemoryError& e) {
    return tell(error, GLARE_ERROR_MEMORY, e.what());
  } catch (const Cancelled& e) {
    return tell(error, GLARE_ERROR_CANCELLED, e.what());
  } catch (const std::bad_alloc&) {
    return tell(error, GLARE_ERROR_MEMORY, "out of memory");
  } catch (const std::exception& e) {
    return tell(error, GLARE_ERROR_INTERNAL, e.what());
  } catch (...) {
    return tell(error, GLARE_ERROR_INTERNAL, "an unknown exception");
  }
}

glare_status told_done(glare_error* error) noexcept { return tell(error, GLARE_OK, ""); }

void give_text(const std::string& text, char* buffer, std::size_t size, std::size_t* needed) {
  if (size > 0) {
    require(buffer, "buffer");
    const std::size_t length = cut_length(text.data(), text.size(), size - 1);
    std::memcpy(buffer, text.data(), length);
    buffer[length] = '\0';
  }
  if (needed != nullptr) *needed = text.size() + 1;
}

ProgressCallback progress_of(glare_progress progress, void* user) {
  if (progress == nullptr) return {};
  return [progress, user](double fraction) { return progress(fraction, user) != 0; };
}

int threads_of(std::int32_t threads) {
  if (threads < 0 || threads > 1024)
    throw OptionError("threads is " + std::to_string(threads) + ", expected 0 to 1024");
  return threads;
}

std::uint64_t limit_or_usual(std::uint64_t bytes) {
  return bytes != 0 ? bytes : default_memory_limit_bytes();
}

}  // namespace glare::c

extern "C" const char* glare_version(void) { return GLARE_VERSION; }
