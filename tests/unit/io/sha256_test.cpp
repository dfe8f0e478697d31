#include "glare/io/sha256.h"

#include <gtest/gtest.h>

#include "glare/base/error.h"
#include "support/scratch_folder.h"

namespace glare {
namespace {

std::string sha256_of_text(std::string_view text) {
  return sha256_of(std::as_bytes(std::span(text)));
}

TEST(Sha256, ExamplesOfFips180) {
  EXPECT_EQ(sha256_of_text(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of_text("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_text("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_of_text(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfAFile) {
  const test::ScratchFolder folder;
  test::set_file_text(folder / "abc", "abc");
  EXPECT_EQ(sha256_of_file(folder / "abc"), sha256_of_text("abc"));
  EXPECT_THROW(sha256_of_file(folder / "none"), InputError);
}

}  // namespace
}  // namespace glare
