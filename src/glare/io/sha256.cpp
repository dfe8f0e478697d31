#include "glare/io/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <cstdint>
#include <limits>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"

namespace glare {

std::string sha256_of(std::span<const std::byte> bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw Error("SHA-256 isn't available in this machine's libcrypto");
  constexpr char hex_digit[] = "0123456789abcdef";
  std::string hex;
  for (unsigned int i = 0; i < length; ++i) {
    hex += hex_digit[digest[i] >> 4];
    hex += hex_digit[digest[i] & 15];
  }
  return hex;
}

std::string sha256_of_file(const std::filesystem::path& path) {
  return sha256_of(read_file(path, std::numeric_limits<std::uint64_t>::max()));
}

}  // namespace glare
