// Upper and lower case beyond ASCII, and the words of names.
#include <opal/common/letter_case.hpp>

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("letters of any alphabet get upper case, and all others stay") {
  CHECK(upper_case_letters("wände, fenêtre, ściany, żółć, őr, ždiar") == "WÄNDE, FENÊTRE, ŚCIANY, ŻÓŁĆ, ŐR, ŽDIAR");
  CHECK(upper_case_letters("стены ёж їжак τοίχος ψ") == "СТЕНЫ ЁЖ ЇЖАК ΤΟΊΧΟΣ Ψ");
  CHECK(upper_case_letters("÷ß 墙体 벽 קיר 1_a") == "÷ẞ 墙体 벽 קיר 1_A");
  CHECK(upper_case_letters("\xE4\xF6 \xC3") == "\xE4\xF6 \xC3");
}

TEST_CASE("lower case is the other way round") {
  CHECK(lower_case_letters("WÄNDE, СТЕНЫ, ΤΟΊΧΟΣ, 墙 1_A") == "wände, стены, τοίχοσ, 墙 1_a");
  CHECK(lower_case_letters("\xE4 IFC4") == "\xE4 ifc4");
}

TEST_CASE("words of a name end at digits, signs and before capitals") {
  CHECK(words_of_name("0_Murature 2") == std::vector<std::string>{"MURATURE"});
  CHECK(words_of_name("MuroNuevo-äußereWände") == std::vector<std::string>{"MURO", "NUEVO", "ÄUẞERE", "WÄNDE"});
  CHECK(words_of_name("внутрСтены+벽체") == std::vector<std::string>{"ВНУТР", "СТЕНЫ", "벽체"});
  CHECK(words_of_name("").empty());
  CHECK(words_of_name("0-1").empty());
}

TEST_CASE("words are known as a whole") {
  constexpr std::string_view kKnown[] = {"WALL", "MUR"};
  CHECK(has_any_word(words_of_name("old mur"), kKnown));
  CHECK_FALSE(has_any_word(words_of_name("walls"), kKnown));
  CHECK_FALSE(has_any_word({}, kKnown));
}
