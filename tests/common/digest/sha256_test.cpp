#include "common/digest/sha256.hpp"

#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using opal::sha256_of;

TEST_CASE("SHA-256 of the examples of FIPS 180-4") {
  CHECK(sha256_of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256_of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256_of(std::string(1'000'000, 'a')) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("SHA-256 of every length around the blocks is that of Python's hashlib") {
  opal::Sha256 all;
  for (int length = 0; length < 300; ++length) {
    std::string text;
    for (int k = 0; k < length; ++k) text += static_cast<char>((k * 7 + length) % 256);
    all.add(sha256_of(text));
  }
  // over the same 300 texts
  CHECK(all.finish() == "def85da8f53f8ad58eda585dce61c0d7bfbb3da6924badae49d32d11288c576f");
}

TEST_CASE("SHA-256 does not depend on how the bytes are cut") {
  std::string text;
  for (int k = 0; k < 1000; ++k) text += static_cast<char>(k * k % 251);
  for (const std::size_t piece : {1, 3, 63, 64, 65, 200}) {
    opal::Sha256 hash;
    for (std::size_t at = 0; at < text.size(); at += piece) hash.add(std::string_view(text).substr(at, piece));
    CHECK(hash.finish() == sha256_of(text));
  }
}

TEST_CASE("SHA-256 of a file is that of its bytes; a file that is not there is named") {
  const opal::TemporaryFolder folder;
  const std::string text(200'000, '\x7f');
  CHECK(opal::sha256_of_file(folder.write("bytes", text)) == sha256_of(text));
  CHECK_THROWS_WITH(opal::sha256_of_file(folder.path_of("absent")), folder.path_of("absent") + ": cannot be read");
}
