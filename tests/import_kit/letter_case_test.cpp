// Upper and lower case beyond ASCII, and the words of names.
#include <opal/import_kit/class_rules.hpp>
#include <opal/import_kit/letter_case.hpp>

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("letters of Latin, Greek and Cyrillic get upper case, and all others stay") {
  CHECK(upper_case_letters("wände, fenêtre, ściany, żółć, őr, ždiar") == "WÄNDE, FENÊTRE, ŚCIANY, ŻÓŁĆ, ŐR, ŽDIAR");
  CHECK(upper_case_letters("стены ёж їжак τοίχος ψ") == "СТЕНЫ ЁЖ ЇЖАК ΤΟίΧΟς Ψ");
  CHECK(upper_case_letters("÷ß 墙体 벽 קיר 1_a") == "÷ß 墙体 벽 קיר 1_A");
  CHECK(upper_case_letters("\xE4\xF6 \xC3") == "\xE4\xF6 \xC3");
}

TEST_CASE("words of a name end at digits, signs and before capitals") {
  CHECK(words_of_name("0_Murature 2") == std::vector<std::string>{"MURATURE"});
  CHECK(words_of_name("MuroNuevo-äußereWände") == std::vector<std::string>{"MURO", "NUEVO", "ÄUßERE", "WÄNDE"});
  CHECK(words_of_name("внутрСтены+벽체") == std::vector<std::string>{"ВНУТР", "СТЕНЫ", "벽체"});
  CHECK(words_of_name("").empty());
  CHECK(words_of_name("0-1").empty());
}

TEST_CASE("class rules are the same in upper and lower case of any alphabet") {
  const ClassRules rules({{"*СТЕНЫ*", "Wall"}}, {{"*TÜREN*", "Door"}});
  CHECK(rules.class_of("наружные стены") == "opal:Wall");
  CHECK(rules.class_of("Türen") == "opal:Door");
  CHECK(rules.unused({"Стены"}).empty());
}
