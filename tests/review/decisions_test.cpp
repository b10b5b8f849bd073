#include "made_review.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::made;
using Catch::Matchers::Contains;

namespace {

Decisions all_kinds() {
  const Review review(matter(drives()));
  Decisions decisions = said(review, {{"wall-0", Answer::accepted},
                                      {"wall-2", Answer::refused},
                                      {"learned-1", Answer::accepted},
                                      {"wall-3", Answer::refused}});
  decisions.all[0].by = "<b>Ada</b>";
  decisions.all[0].at = "2026-11-25T10:00:00Z";
  decisions.all[0].note = "seen \"with\" my own eyes\n";
  return decisions;
}

nlohmann::json document() { return nlohmann::json::parse(to_json(all_kinds()).dump()); }

Decisions read(const nlohmann::json& json) { return decisions_from(json, "d.json"); }

}  // namespace

TEST_CASE("a document of decisions says the same when it is read") {
  const Decisions again = read(document());
  CHECK(to_json(again).dump() == to_json(all_kinds()).dump());
  for (std::size_t k = 0; k < again.all.size(); ++k) CHECK(is_same(again.all[k].about, all_kinds().all[k].about));
}

TEST_CASE("a subject is the same while the map says the same and drives say nearly the same") {
  const Subject subject = all_kinds().all[0].about;
  Subject other = subject;
  other.moved.y() += 0.04;
  CHECK(is_same(subject, other));
  other.moved.y() += 0.02;
  CHECK_FALSE(is_same(subject, other));
  other = subject;
  other.mapped[0][0] += 0.001;
  CHECK_FALSE(is_same(subject, other));
  other = subject;
  other.change = Change::gone;
  CHECK_FALSE(is_same(subject, other));
  other = subject;
  other.is_disputed = true;
  CHECK_FALSE(is_same(subject, other));
}

TEST_CASE("something added is known by its place, not by its number") {
  const Subject subject = all_kinds().all[2].about;
  Subject other = subject;
  other.id = "learned-7";
  CHECK(is_same(subject, other));
  other.face.end.x() += 0.06;
  CHECK_FALSE(is_same(subject, other));
}

TEST_CASE("a document that is none is refused with place, what was found and what was expected") {
  const auto refused = [](const char* pointer, const nlohmann::json& value, const std::string& words) {
    nlohmann::json json = document();
    json[nlohmann::json::json_pointer(pointer)] = value;
    CAPTURE(pointer, value.dump());
    CHECK_THROWS_WITH(read(json), Contains("d.json: ") && Contains(words));
  };
  refused("/opal_decisions", 2, "/opal_decisions: 2, expected the format of decisions, 1");
  refused("/map", 7, "/map: 7, expected a text");
  refused("/decisions", "all", "/decisions: \"all\", expected a list");
  refused("/decisions/1", 3, "/decisions/1: 3, expected an object");
  refused("/decisions/1/answer", "maybe",
          "/decisions/1/answer: \"maybe\", expected one of: undecided, accepted, refused");
  refused("/decisions/0/about/change", "away",
          "/decisions/0/about/change: \"away\", expected one of: moved, gone, added");
  refused("/decisions/0/about/moved", nlohmann::json::array({1}), "/about/moved: [1], expected 2 numbers");
  refused("/decisions/0/about/moved", nlohmann::json::array({"a", 2}), "expected 2 numbers");
  refused("/decisions/0/about/mapped", nlohmann::json::object(), "expected an array of arrays of numbers");
  refused("/decisions/2/about/face", nullptr, "/decisions/2/about/face: null, expected 4 numbers");
  refused("/decisions/0/about/disputed", "no", "expected true or false");
  refused("/decisions/3/answer", "accepted", "expected refused or undecided: visits contradict each other");
  refused("/decisions/0/note", std::string(2001, 'x'), "expected a text of 2000 bytes at most");
  refused("/decisions/0/shoe", 1, "/decisions/0/shoe: unknown key");
  refused("/more", 1, "/more: unknown key");
  CHECK_THROWS_WITH(read(nlohmann::json::array()), Contains("d.json: /: [], expected an object"));
  CHECK_THROWS_WITH(read(nlohmann::json::object()), Contains("/opal_decisions: absent"));
}
