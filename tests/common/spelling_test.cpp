#include "common/spelling.hpp"

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("letters between two words are put in, left out or changed") {
  CHECK(letters_between("scorers", "scorers") == 0);
  CHECK(letters_between("scorer", "scorers") == 1);
  CHECK(letters_between("kitten", "sitting") == 3);
  CHECK(letters_between("", "map") == 3);
  CHECK(letters_between("sitting", "kitten") == letters_between("kitten", "sitting"));
}

TEST_CASE("a slip is up to two letters and fewer than half of the word that is meant") {
  CHECK(is_misspelt("Wal", "Wall"));
  CHECK(is_misspelt("scroers", "scorers"));
  CHECK_FALSE(is_misspelt("Wall", "Wall"));
  CHECK_FALSE(is_misspelt("door", "wall"));
  CHECK_FALSE(is_misspelt("mop", "m"));
}
