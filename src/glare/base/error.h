// The one family of exceptions that Glare throws for bad data, bad requests and failing files.
// Misuse by the programmer (an index out of range) is an assertion instead.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace glare {

/// Base of every exception that Glare throws. `what()` is one line for a person: what happened,
/// where, and what was expected.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An input can't be read or isn't what it should be. `place()` says where: a file, a file and
/// line ("lamp.csv:12"), or a pixel.
class InputError : public Error {
 public:
  InputError(std::string place, const std::string& message)
      : Error(place.empty() ? message : place + ": " + message),
        place_(std::move(place)),
        message_(message) {}
  const std::string& place() const { return place_; }
  /// What happened, without the place.
  const std::string& message() const { return message_; }

 private:
  std::string place_;
  std::string message_;
};

/// A request can't be met: an option has a value outside its range, an unknown name, or a field
/// of view beyond the aperture's reach.
class OptionError : public Error {
 public:
  using Error::Error;
};

/// An output can't be written. Nothing was left under its name that was not there before.
class OutputError : public Error {
 public:
  OutputError(std::string place, const std::string& message)
      : Error(place + ": " + message), place_(std::move(place)) {}
  const std::string& place() const { return place_; }

 private:
  std::string place_;
};

/// More memory would be needed than is allowed. Thrown before anything large is allocated.
class MemoryError : public Error {
 public:
  MemoryError(std::uint64_t required_bytes, std::uint64_t allowed_bytes);
  std::uint64_t required_bytes() const { return required_bytes_; }
  std::uint64_t allowed_bytes() const { return allowed_bytes_; }

 private:
  std::uint64_t required_bytes_;
  std::uint64_t allowed_bytes_;
};

/// The caller's progress callback asked to stop.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

}  // namespace glare
