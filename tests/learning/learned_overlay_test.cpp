#include "made_drives.hpp"

#include "learning/prior_shares.hpp"
#include "map/overlay/map_overlay.hpp"
#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;
using namespace opal::made;
using Catch::Matchers::Contains;

namespace {

const Proposal* proposal_of(const Learned& learned, const std::string& id) {
  const auto at = std::ranges::find_if(learned.proposals, [&](const Proposal& p) { return p.id == id; });
  return at == learned.proposals.end() ? nullptr : &*at;
}

/// The map with what was learned, by way of the document.
std::shared_ptr<const SemanticMap> applied(const SemanticMap& map, const std::vector<DriveEvidence>& drives) {
  const std::string text = overlay_of(map, learned_from(map, drives), kSensor, 0.9).dump();
  return overlaid_map(map, {parse_overlay(text, "learned")}).map;
}

const Segment& face_of(const SemanticMap& map, const std::string& id) {
  for (const MapFeature& feature : map.features())
    if (feature.id == id) return std::get<Segment>(feature.geometry);
  FAIL("no feature " + id);
  throw Error("unreachable");
}

}  // namespace

TEST_CASE("a wall that visits see elsewhere moves along its normal, and its neighbours reach up to it") {
  const auto map = room();
  const std::vector<DriveEvidence> drives{drive("a", {seen("wall-0", kMoved, {0, 0.4}), seen("wall-1", kThere)}),
                                          drive("b", {seen("wall-0", kMoved, {0, 0.42}), seen("wall-3", kThere)})};
  const auto built = applied(*map, drives);
  CHECK(face_of(*built, "wall-0/face").begin.y() == Approx(0.41).margin(0.01));
  CHECK(face_of(*built, "wall-0/face").end.y() == Approx(0.41).margin(0.01));
  CHECK(face_of(*built, "wall-0/face").begin.x() == Approx(0).margin(0.01));
  CHECK(face_of(*built, "wall-1/face").begin.y() == Approx(0.41).margin(0.01));
  CHECK(face_of(*built, "wall-1/face").begin.x() == Approx(8).margin(0.01));
  CHECK(face_of(*built, "wall-2/face").begin.y() == Approx(6).margin(0.001));
}

TEST_CASE("two walls that meet and both stand elsewhere meet where they stand") {
  const auto map = room();
  const std::vector<Deviation> both{seen("wall-0", kMoved, {0, 0.4}), seen("wall-1", kMoved, {-0.3, 0})};
  const auto built = applied(*map, {drive("a", both), drive("b", both)});
  CHECK(face_of(*built, "wall-0/face").end.x() == Approx(7.7).margin(0.01));
  CHECK(face_of(*built, "wall-0/face").end.y() == Approx(0.4).margin(0.01));
}

TEST_CASE("what beams pass through on every visit is not looked for any more") {
  const auto map = room();
  const auto built = applied(*map, {drive("a", {seen("wall-2", kGone)}), drive("b", {seen("wall-2", kGone)})});
  for (const MapFeature& feature : built->features())
    CHECK((feature.sensor == kSensor) == (feature.id != "wall-2/face"));
}

TEST_CASE("a face that the map lacks is added, unless beams pass through it on another visit") {
  const auto map = room();
  const Segment face{{2, 3}, {5, 3}};
  const auto built = applied(*map, {drive("a", {}, {{face, 10, 0}}), drive("b", {}, {{face, 8, 0.1}})});
  CHECK((face_of(*built, "learned-1/face").begin - face.begin).norm() < 0.01);
  CHECK((face_of(*built, "learned-1/face").end - face.end).norm() < 0.01);
  const Learned doubtful =
      learned_from(*map, std::vector{drive("a", {}, {{face, 10, 0}}), drive("b", {}, {{face, 8, 0.9}})});
  REQUIRE(doubtful.proposals.size() == 1);
  CHECK(doubtful.proposals.front().moves_about);
  CHECK(overlay_of(*map, doubtful, kSensor, 0.5).at("@graph").size() == 1);
}

TEST_CASE("what is learned on a map that has learned before gets other names, and can be laid over it") {
  const auto map = room();
  const std::vector<UnmappedFace> first{{{{2, 3}, {5, 3}}, 10, 0}}, second{{{{2, 1}, {5, 1}}, 10, 0}};
  const auto once = applied(*map, {drive("a", {}, first), drive("b", {}, first)});
  const auto twice = applied(*once, {drive("c", {}, second), drive("d", {}, second)});
  CHECK(face_of(*twice, "learned-1/face").begin.y() == Approx(3).margin(0.01));
  CHECK(face_of(*twice, "learned-2/face").begin.y() == Approx(1).margin(0.01));
}

TEST_CASE("one short look changes no map, two long ones do") {
  const auto map = room();
  const auto is_written = [&](const std::vector<DriveEvidence>& drives) {
    return !overlay_of(*map, learned_from(*map, drives), kSensor, 0.9).at("@graph").at(0).at("changes").empty();
  };
  CHECK_FALSE(is_written({drive("a", {seen("wall-0", kMoved, {0, 0.4}, 3)})}));
  CHECK(is_written({drive("a", {seen("wall-0", kMoved, {0, 0.4})}), drive("b", {seen("wall-0", kMoved, {0, 0.4})})}));
}

TEST_CASE("one look changes a map that has turned out to be wrong in many places, and not a good one") {
  std::vector<VerdictLikelihood> good(100, {0.98, 0.01, 0.01}), wrong(50, {0.98, 0.01, 0.01});
  for (int k = 0; k < 50; ++k) wrong.push_back({0.01, 0.98, 0.01});
  CHECK(prior_shares(good)[1] < 0.03);
  CHECK(prior_shares(wrong)[1] > 0.35);
  CHECK(prior_share_of_additions({}) == Approx(0.1));
  CHECK(prior_share_of_additions(std::vector<double>(40, 7)) > 0.6);
}

TEST_CASE("as many visits as a fleet makes are as good as a few") {
  const auto map = room();
  const int visits = GENERATE(5, 200, 1000);
  CAPTURE(visits);
  const std::vector<UnmappedFace> faces{{{{2, 3}, {5, 3}}, 30, 0}};
  std::vector<DriveEvidence> drives;
  for (int k = 0; k < visits; ++k)
    drives.push_back(drive("drive " + std::to_string(k), {seen("wall-0", kThere)}, faces));
  const Learned learned = learned_from(*map, drives);
  REQUIRE(learned.proposals.size() == 1);
  CHECK(learned.proposals.front().probability > 0.99);
  CHECK(learned.proposals.front().probability <= 1);
}

TEST_CASE("an object that no visit has seen elsewhere is not moved, however many others are") {
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  std::vector<Deviation> said;
  for (int k = 0; k < 600; ++k) {
    const std::string id = "wall-" + std::to_string(k);
    objects.push_back({id, "opal:Wall"});
    features.push_back({id + "/face", MapObjectNumber(k), "opal:Wall", kSensor, Segment{{0, 2. * k}, {8, 2. * k}}});
    said.push_back(k == 0 ? seen(id, kThere, Point::Zero(), 1) : seen(id, kMoved, {0, 0.4}));
  }
  const auto map = SemanticMap::make("room", objects, features);
  const std::vector<DriveEvidence> drives{drive("a", said)};
  const Learned learned = learned_from(*map, drives);
  CHECK(proposal_of(learned, "wall-0") == nullptr);
  CHECK(proposal_of(learned, "wall-1") != nullptr);
  for (const Proposal& proposal : learned.proposals) CHECK(proposal.moved.allFinite());
}

TEST_CASE("faces of one object move by as much as each was seen elsewhere") {
  const auto map = room();
  Deviation wall = seen("wall-0", kMoved, {0, 0.4});
  wall.faces = {{"wall-0/face", 0.25, 0.03}};
  const auto built = applied(*map, {drive("a", {wall}), drive("b", {wall})});
  CHECK(face_of(*built, "wall-0/face").begin.y() == Approx(0.25).margin(0.01));
}

TEST_CASE("a thin wall whose sides are seen further inwards than it is thick keeps its ends") {
  const Point corners[] = {{0, 0}, {4, 0}, {4, 0.1}, {0, 0.1}};
  std::vector<MapFeature> features;
  for (int k = 0; k < 4; ++k) {
    features.push_back({"wall/face-" + std::to_string(k), MapObjectNumber(0), "opal:Wall", kSensor,
                        Segment{corners[k], corners[(k + 1) % 4]}});
    features.back().points = {"corner-" + std::to_string(k), "corner-" + std::to_string((k + 1) % 4)};
  }
  const auto map = SemanticMap::make("hall", {{"wall", "opal:Wall"}}, features);
  const double inwards_m = GENERATE(0.051, 0.06, 0.3);
  CAPTURE(inwards_m);
  Deviation wall = seen("wall", kMoved, {0, 0.06});
  wall.faces = {{"wall/face-0", inwards_m, 0.01}, {"wall/face-2", inwards_m, 0.01}};
  const auto built = applied(*map, {drive("a", {wall}), drive("b", {wall})});
  for (const MapFeature& feature : map->features()) {
    const Segment& before = std::get<Segment>(feature.geometry);
    CHECK(face_of(*built, feature.id).direction().dot(before.direction()) > 0.9);
  }
}

TEST_CASE("drives that contradict each other are shown, not averaged") {
  const auto map = room();
  const std::vector<DriveEvidence> drives{drive("a", {seen("wall-0", kMoved, {0, 0.6})}),
                                          drive("b", {seen("wall-0", kMoved, {0, -0.5})})};
  const Learned learned = learned_from(*map, drives);
  REQUIRE(proposal_of(learned, "wall-0"));
  CHECK(proposal_of(learned, "wall-0")->is_conflicting);
  CHECK_THAT(sentence_of(*proposal_of(learned, "wall-0")), Contains("visits place it differently"));
  CHECK(overlay_of(*map, learned, kSensor, 0.5).at("@graph").at(0).at("changes").empty());
}

TEST_CASE("a thing that is there on one visit and gone on another moves about, and stays on the map") {
  const auto map = room();
  const std::vector<DriveEvidence> drives{drive("a", {seen("wall-0", kGone)}), drive("b", {seen("wall-0", kGone)}),
                                          drive("c", {seen("wall-0", kThere, {}, 3)})};
  const Learned learned = learned_from(*map, drives);
  REQUIRE(proposal_of(learned, "wall-0"));
  CHECK(proposal_of(learned, "wall-0")->moves_about);
  CHECK(overlay_of(*map, learned, kSensor, 0.5).at("@graph").at(0).at("changes").empty());
}

TEST_CASE("many visits that find a wall where it is outvote one that did not") {
  const auto map = room();
  std::vector<DriveEvidence> drives{drive("odd", {seen("wall-0", kMoved, {0, 0.3})})};
  for (const char* name : {"a", "b", "c"}) drives.push_back(drive(name, {seen("wall-0", kThere)}));
  const Learned learned = learned_from(*map, drives);
  CHECK(learned.proposals.empty());
  CHECK(learned.sound == 1);
  CHECK(learned.unseen == 3);
}

TEST_CASE("the order in which drives arrive, and arriving twice, changes no byte") {
  const auto map = room();
  std::vector<DriveEvidence> drives;
  for (int k = 0; k < 6; ++k)
    drives.push_back(drive("drive " + std::to_string(k),
                           {seen("wall-0", kMoved, {0, 0.3 + 0.01 * k}), seen("wall-2", kGone)},
                           {{{{2, 3 + 0.01 * k}, {5, 3}}, 6 + k, 0}}));
  const std::string once = overlay_of(*map, learned_from(*map, drives), kSensor, 0.9).dump();
  std::ranges::reverse(drives);
  CHECK(overlay_of(*map, learned_from(*map, drives), kSensor, 0.9).dump() == once);
  std::rotate(drives.begin(), drives.begin() + 2, drives.end());
  drives.push_back(drives.front());
  CHECK(overlay_of(*map, learned_from(*map, drives), kSensor, 0.9).dump() == once);
}

TEST_CASE(
    "what was never recognized is gone after two visits that looked for it long enough, and not after two glances") {
  const auto map = room();
  const auto probability_after = [&](int keyframes) {
    const std::vector<DriveEvidence> drives{drive("a", {seen("wall-2", kGone, {}, keyframes)}),
                                            drive("b", {seen("wall-2", kGone, {}, keyframes)})};
    const Learned learned = learned_from(*map, drives);
    const Proposal* proposal = proposal_of(learned, "wall-2");
    return proposal ? proposal->probability : 0;
  };
  CHECK(probability_after(12) > 0.9);
  CHECK(probability_after(1) < 0.9);
}

TEST_CASE("evidence that does not tell how often it looked is read as before") {
  nlohmann::json document = nlohmann::json::parse(to_json(drive("a", {seen("wall-0", kMoved)})).dump());
  document["visits"][0]["objects"][0].erase("looks");
  CHECK(drive_evidence_from(document, "a.json").visits[0].objects[0].looks == 12);
}

TEST_CASE("the evidence of a drive is a document that says the same when it is read") {
  const DriveEvidence evidence =
      drive("a", {seen("wall-0", kMoved, {0.1, 0.4}), seen("wall-1", kGone)}, {{{{2, 3}, {5, 3}}, 7, 0.25}});
  const nlohmann::json document = nlohmann::json::parse(to_json(evidence).dump());
  CHECK(to_json(drive_evidence_from(document, "a.json")).dump() == to_json(evidence).dump());
}

TEST_CASE("a number in evidence that nothing can be is refused with what was found and what was expected") {
  const auto refused = [](const char* key, const nlohmann::json& value) {
    nlohmann::json document = nlohmann::json::parse(to_json(drive("a", {seen("wall-0", kMoved)})).dump());
    document["visits"][0]["objects"][0][key] = value;
    return refused_with<ConfigError>([&] { drive_evidence_from(document, "x.json"); });
  };
  CHECK(refused("observations", 1e300) == "x.json: observations 1e+300, expected 0.0 to 1000000000.0");
  CHECK_THAT(refused("observations", -1), Contains("expected 0.0 to"));
  CHECK_THAT(refused("seen_through_share", 1.5), Contains("seen_through_share 1.5, expected 0.0 to 1.0"));
  CHECK_THAT(refused("moved_x_m", 1e300), Contains("moved_x_m 1e+300"));
  CHECK_THAT(refused("sigma_m", -0.1), Contains("sigma_m -0.1"));
}

TEST_CASE("a document that is no evidence is refused by name") {
  nlohmann::json document = nlohmann::json::parse(to_json(drive("a", {seen("wall-0", kMoved)})).dump());
  CHECK_THROWS_WITH(drive_evidence_from(nlohmann::json::object(), "x.json"),
                    Contains("x.json") && Contains("opal_evidence"));
  document["visits"][0]["objects"][0]["verdict"] = "sideways";
  CHECK_THROWS_WITH(drive_evidence_from(document, "x.json"),
                    Contains("sideways") && Contains("as mapped, moved, probably absent"));
  document["opal_evidence"] = 7;
  CHECK_THROWS_WITH(drive_evidence_from(document, "x.json"), Contains("format 7, expected 1"));
}

TEST_CASE("beams that pass through an object say more than as many that end near it") {
  const auto map = made::room();
  const auto alone = [&](DeviationVerdict verdict) {
    return learned_from(*map, std::vector{made::drive("a", {made::seen("wall-0", verdict, {0, 0.3}, 4)})}).proposals;
  };
  const auto gone = alone(made::kGone), moved = alone(made::kMoved);
  REQUIRE(gone.size() == 1);
  CHECK(gone.front().probability > (moved.empty() ? 0 : moved.front().probability) + 0.1);
}
