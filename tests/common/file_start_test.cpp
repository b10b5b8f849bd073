#include <opal/common/file_start.hpp>

#include "tests/kit/temporary_folder.hpp"

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("the first bytes of a file are no more than it has") {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.bin", std::string("ab\0cd", 5));
  CHECK(first_bytes(path, 4) == std::string("ab\0c", 4));
  CHECK(first_bytes(path, 100).size() == 5);
  CHECK(first_bytes(folder.path_of("absent"), 4).empty());
  CHECK(first_bytes(folder.path(), 4).empty());
}

TEST_CASE("a byte order mark is removed once, and only at the start") {
  std::string text = "\xEF\xBB\xBF\xEF\xBB\xBFwords";
  erase_byte_order_mark(text);
  CHECK(text == "\xEF\xBB\xBFwords");
  text = "words \xEF\xBB\xBF";
  erase_byte_order_mark(text);
  CHECK(text == "words \xEF\xBB\xBF");
}
