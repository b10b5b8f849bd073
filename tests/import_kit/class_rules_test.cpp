#include <opal/import_kit/class_rules.hpp>

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("class rules are the same in upper and lower case of any alphabet") {
  const ClassRules rules({{"*СТЕНЫ*", "Wall"}}, {{"*TÜREN*", "Door"}, {"*ΤΟΊΧΟΣ*", "Wall"}});
  CHECK(rules.class_of("наружные стены") == "opal:Wall");
  CHECK(rules.class_of("Türen") == "opal:Door");
  CHECK(rules.class_of("τοίχος") == "opal:Wall");
  CHECK(rules.unused({"Стены"}).empty());
}
