#include "common/phrases.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace opal;

TEST_CASE("things are counted and listed") {
  const std::vector<std::string> letters{"a", "b", "c"};
  CHECK(count_of(1, "wall") == "1 wall");
  CHECK(count_of(2, "wall") == "2 walls");
  CHECK(listed(letters) == "a, b, c");
  CHECK(listed(letters, "", 1) == "a and 2 more");
  CHECK(listed(std::vector<std::string>{}, "none") == "none");
}

TEST_CASE("things are listed by a member or by what a function says of them") {
  struct Thing {
    std::string name;
  };
  CHECK(listed_by(std::vector<Thing>{{"one"}, {"two"}}, &Thing::name) == "one, two");
  const std::map<std::string, int> counts{{"doors", 2}, {"walls", 5}};
  CHECK(listed_by(counts, [](const auto& one) { return std::to_string(one.second) + " " + one.first; }) ==
        "2 doors, 5 walls");
  CHECK(listed_by(std::vector<Thing>{}, &Thing::name).empty());
}
