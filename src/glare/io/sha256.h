// Fingerprints of files, for the recipe that a template carries.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace glare {

/// SHA-256 (FIPS 180-4) of some bytes, as 64 lower-case hexadecimal digits.
std::string sha256_of(std::span<const std::byte> bytes);

/// SHA-256 of a file's content. Throws `InputError` where it can't be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace glare
