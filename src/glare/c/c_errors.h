// Exceptions as statuses, and what every function of glare_c.h asks of its arguments. Internal.
#pragma once

#include <exception>
#include <string>

#include "glare/base/error.h"
#include "glare/base/progress.h"
#include "glare/glare_c.h"

namespace glare::c {

/// The exception as a status, with its message in `error`, unless that is null.
glare_status told(const std::exception_ptr& thrown, glare_error* error) noexcept;

/// No error.
glare_status told_done(glare_error* error) noexcept;

/// Does `work`; what it throws becomes the status.
template <typename Work>
glare_status guarded(glare_error* error, const Work& work) noexcept {
  try {
    work();
  } catch (...) {
    return told(std::current_exception(), error);
  }
  return told_done(error);
}

/// Throws `OptionError` where a pointer is null.
inline void require(const void* pointer, const char* name) {
  if (pointer == nullptr) throw OptionError(std::string(name) + " is NULL");
}

/// Empties the place of a handle that is to be made.
template <typename Handle>
void require_place(Handle** place, const char* name) {
  require(place, name);
  *place = nullptr;
}

/// An empty text for null.
inline std::string text_or_empty(const char* text) { return text == nullptr ? "" : text; }

/// `values[index]`. Throws `OptionError`, naming the field, for an index beyond them.
template <typename T, std::size_t count>
T choice(const T (&values)[count], std::int32_t index, const char* name) {
  if (index < 0 || static_cast<std::size_t>(index) >= count)
    throw OptionError(std::string(name) + " is " + std::to_string(index) + ", expected 0 to " +
                      std::to_string(count - 1));
  return values[index];
}

/// Puts a text into a caller's buffer, as glare_c.h has it.
void give_text(const std::string& text, char* buffer, std::size_t size, std::size_t* needed);

/// The caller's function; an empty callback for null.
ProgressCallback progress_of(glare_progress progress, void* user);

/// The caller's number of threads. Throws `OptionError` where it isn't 0 to 1024.
int threads_of(std::int32_t threads);

/// The caller's limit, or the usual one for 0.
std::uint64_t limit_or_usual(std::uint64_t bytes);

}  // namespace glare::c
