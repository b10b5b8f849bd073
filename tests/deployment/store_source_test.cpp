#include "deployment/store_source.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("a map in the store is named by its building, and by a version if not the newest is meant") {
  CHECK_FALSE(read_store_source("maps/hall.jsonld"));
  CHECK_FALSE(read_store_source("STORE:hall"));
  const auto is = [](const std::string& text, const std::string& building, int version) {
    const auto source = read_store_source(text);
    return source && source->building == building && source->version == version;
  };
  CHECK(is("store:hall", "hall", 0));
  CHECK(is("store:hall@3", "hall", 3));
  CHECK(is("store:hall@newest", "hall", 0));
  CHECK(is("store:me@home", "me@home", 0));
  CHECK(is("store:me@home@12", "me@home", 12));
  CHECK(is("store:a:b/c d", "a:b/c d", 0));
}

TEST_CASE("every building and version can be named") {
  for (const std::string building : {"hall", "me@home", "hall@3", "hall@newest", "@", "a b", "@@1"})
    for (const int version : {0, 1, 2147483647}) {
      CAPTURE(building, version);
      const auto again = read_store_source(text_of({building, version}));
      REQUIRE(again);
      CHECK(again->building == building);
      CHECK(again->version == version);
    }
}

TEST_CASE("a source without a building or with an impossible version is refused") {
  for (const std::string text : {"store:", "store:@3", "store:hall@0", "store:hall@99999999999"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(read_store_source(text), ConfigError);
  }
}
