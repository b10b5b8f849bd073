#include "made_review.hpp"

#include "map/overlay/map_overlay.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::made;
using Catch::Matchers::Contains;

namespace {

/// Targets of changes and ids of additions.
std::string changed(const nlohmann::ordered_json& overlay) {
  std::string names;
  const auto add = [&](const nlohmann::ordered_json& name) {
    names += (names.empty() ? "" : " ") + name.get<std::string>();
  };
  for (const auto& change : overlay.at("@graph").at(0).at("changes")) add(change.at("target"));
  for (std::size_t k = 1; k < overlay.at("@graph").size(); ++k) add(overlay.at("@graph").at(k).at("@id"));
  return names;
}

}  // namespace

TEST_CASE("the overlay of a review holds exactly what was accepted") {
  Review review(matter(drives()));
  CHECK(changed(review.overlay()).empty());
  review.take(said(review, {{"wall-2", Answer::accepted}, {"wall-0", Answer::refused}}), "page");
  CHECK(changed(review.overlay()) == "wall-2");
  review.take(said(review, {{"learned-1", Answer::accepted}, {"wall-2", Answer::undecided}}), "page");
  CHECK(changed(review.overlay()) == "learned-1");
  review.take(said(review, {{"wall-0", Answer::accepted}}), "page");
  CHECK(changed(review.overlay()) == "corner-0 corner-1 learned-1");
  CHECK(review.count() == "2 of 4 decided, 2 accepted");
}

TEST_CASE("who accepts all that is probable enough gets the overlay that no person looked at") {
  const ReviewMatter all = matter(drives());
  Review review(all);
  review.take(
      said(review, {{"wall-0", Answer::accepted}, {"wall-2", Answer::accepted}, {"learned-1", Answer::accepted}}),
      "page");
  CHECK(review.overlay().dump() == overlay_of(*all.map, all.learned, kSensor, 0.9).dump());
  CHECK_FALSE(changed(review.overlay()).empty());
}

TEST_CASE("a person may accept what is less probable than drives alone would need") {
  const std::vector<DriveEvidence> once{drive("monday", {seen("wall-2", kGone)})};
  ReviewMatter one = matter(once);
  REQUIRE(one.learned.proposals.size() == 1);
  one.learned.proposals[0].probability = 0.6;
  Review review(one);
  review.take(said(review, {{"wall-2", Answer::accepted}}), "page");
  CHECK(changed(review.overlay()) == "wall-2");
}

TEST_CASE("what visits contradict each other about never gets into the overlay") {
  Review review(matter(drives()));
  Decisions decisions = said(review, {{"wall-3", Answer::accepted}});
  review.take(decisions, "page");
  CHECK(changed(review.overlay()).empty());
}

TEST_CASE("a decision about something that is not proposed is refused, and with it all others") {
  Review review(matter(drives()));
  Decisions decisions = said(review, {{"wall-2", Answer::accepted}, {"wall-0", Answer::accepted}});
  decisions.all[1].about.moved = {5, 5};
  CHECK_THROWS_WITH(review.take(decisions, "the page"), Contains("the page: /decisions/1/about: ") &&
                                                            Contains("wall-0") && Contains("one of the 4 proposals"));
  CHECK(answer_on(review, "wall-2") == Answer::undecided);
}

TEST_CASE("a review goes on where it stopped, and says nothing if nothing has changed") {
  Review first(matter(drives()));
  first.take(said(first, {{"wall-2", Answer::accepted}, {"wall-0", Answer::refused}}), "page");
  Review second(matter(drives()));
  CHECK(second.resume(first.decisions(), "d.json").empty());
  CHECK(answer_on(second, "wall-2") == Answer::accepted);
  CHECK(answer_on(second, "wall-0") == Answer::refused);
  CHECK(second.overlay() == first.overlay());
}

TEST_CASE("with other evidence, decisions about the same stay, others are asked again and kept") {
  Review first(matter(drives()));
  first.take(said(first, {{"wall-2", Answer::accepted}, {"wall-0", Answer::accepted}, {"learned-1", Answer::refused}}),
             "page");
  Review second(matter(drives(0.6), "e2"));
  const std::vector<std::string> notes = second.resume(first.decisions(), "d.json");
  REQUIRE(notes.size() == 2);
  CHECK(notes[0] == "d.json: since then the evidence has changed; 2 of 3 decisions hold as they are");
  CHECK_THAT(notes[1], Contains("moved wall-0 was accepted") && Contains("look again"));
  CHECK(answer_on(second, "wall-2") == Answer::accepted);
  CHECK(answer_on(second, "learned-1") == Answer::refused);
  CHECK(answer_on(second, "wall-0") == Answer::undecided);
  CHECK(changed(second.overlay()) == "wall-2");
  Review third(matter(drives()));
  third.resume(second.decisions(), "d.json");
  CHECK(answer_on(third, "wall-0") == Answer::accepted);
  second.take(said(second, {{"wall-0", Answer::refused}}), "page");
  CHECK(second.decisions().all.size() == 3);
}

TEST_CASE("the number of an addition may change with other evidence, and the decision finds it again") {
  Review first(matter(drives()));
  first.take(said(first, {{"learned-1", Answer::accepted}}), "page");
  std::vector<DriveEvidence> more = drives();
  const UnmappedFace another{{{1, 1}, {3, 1}}, 8, 0};
  for (DriveEvidence& each : more) each.visits[0].unmapped.insert(each.visits[0].unmapped.begin(), another);
  Review second(matter(more, "e2"));
  CHECK(second.resume(first.decisions(), "d.json").size() == 1);
  CHECK(answer_on(second, "learned-1") == Answer::undecided);
  CHECK(answer_on(second, "learned-2") == Answer::accepted);
  CHECK(changed(second.overlay()) == "learned-2");
}

TEST_CASE("what has become a conflict since it was accepted is asked again") {
  std::vector<DriveEvidence> clear{drive("a", {seen("wall-0", kMoved, {0, 0.4})}),
                                   drive("b", {seen("wall-0", kMoved, {0, 0.4})})};
  Review first(matter(clear));
  first.take(said(first, {{"wall-0", Answer::accepted}}), "page");
  clear.push_back(drive("c", {seen("wall-0", kGone, {}, 2)}));
  Review second(matter(clear, "e2"));
  CHECK(second.resume(first.decisions(), "d.json").size() == 2);
  CHECK(answer_on(second, "wall-0") == Answer::undecided);
  CHECK(changed(second.overlay()).empty());
}

TEST_CASE("decisions about another map are refused by name") {
  Review review(matter(drives()));
  CHECK_THROWS_WITH(review.resume(Decisions{"elsewhere", "m1", "e1"}, "d.json"),
                    Contains("d.json: /map: \"elsewhere\", expected \"room\""));
}

TEST_CASE("what is saved is read again, and the overlay can be laid over the map") {
  const TemporaryFolder folder;
  Review review(matter(drives()));
  review.take(said(review, {{"wall-0", Answer::accepted}, {"learned-1", Answer::accepted}}), "page");
  const ReviewFiles files{folder.path() + "/r.decisions.json", folder.path() + "/r.jsonld"};
  save(review, files);
  Review again(matter(drives()));
  again.resume(decisions_from(read_json(files.decisions), files.decisions), files.decisions);
  CHECK(again.overlay() == review.overlay());
  CHECK(overlaid_map(*room(), {read_overlay(files.overlay)}).changes.size() >= 3);
}
