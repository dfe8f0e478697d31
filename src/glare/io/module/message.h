// Text across the interface of a module. Internal.
#pragma once

#include <cstddef>
#include <string_view>

namespace glare::module {

/// A message that a module gives back, in room of its caller's.
struct Message {
  char text[8192] = "";

  /// Sets the text; what is beyond the room is left out.
  void set(std::string_view message) noexcept {
    const std::size_t length = message.copy(text, sizeof text - 1);
    text[length] = '\0';
  }
};

}  // namespace glare::module
