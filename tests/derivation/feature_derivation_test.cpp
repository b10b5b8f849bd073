#include "derivation/feature_derivation.hpp"

#include "plugins/boxes/detector.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;
using Catch::Matchers::Contains;

namespace {

const std::vector<std::string> kPillarCorner{"opal:PillarCorner"};
constexpr double kSide_m = 0.4;

/// A room of 10 m by 8 m with a square pillar in it and one in its corner.
class Hall {
 public:
  explicit Hall(const Pose2& T_map_hall = {}) : T_map_hall_(T_map_hall) {
    object("wall", "opal:Wall", {{0, 0}, {10, 0}, {10, 8}, {0, 8}});
    object("pillar", "opal:Column", box(kPillar));
    object("built-in", "opal:Column", box({0.2, 0.2}));
  }
  std::shared_ptr<const SemanticMap> map() const { return SemanticMap::make("hall", objects_, features_); }
  inline static const Point kPillar{4, 3};

 private:
  static std::vector<Point> box(const Point& center) {
    const double a = kSide_m / 2;  // clockwise: seen from outside
    return {center + Point(-a, -a), center + Point(-a, a), center + Point(a, a), center + Point(a, -a)};
  }
  void object(const std::string& id, const std::string& type, const std::vector<Point>& corners) {
    objects_.push_back({id, type});
    for (std::size_t k = 0; k < corners.size(); ++k)
      features_.push_back({id + "/face-" + std::to_string(k), MapObjectNumber(objects_.size() - 1), "opal:Wall",
                           "PlanarLidar2D",
                           transformed(T_map_hall_, Segment{corners[k], corners[(k + 1) % corners.size()]})});
  }
  Pose2 T_map_hall_;
  std::vector<MapObject> objects_;
  std::vector<MapFeature> features_;
};

std::vector<MapFeature> pillar_corners(const SemanticMap& map) {
  std::vector<MapFeature> found;
  std::copy_if(map.features().begin(), map.features().end(), std::back_inserter(found),
               [](const MapFeature& feature) { return feature.type == "opal:PillarCorner"; });
  return found;
}

/// The pillar's edges as they are: open to 270 degrees, outward.
std::vector<OrientedPoint> true_edges(const Pose2& T_map_hall) {
  std::vector<OrientedPoint> edges;
  for (const Point& side : {Point(1, 1), Point(-1, 1), Point(-1, -1), Point(1, -1)})
    edges.push_back({T_map_hall * Point(Hall::kPillar + kSide_m / 2 * side),
                     wrap_angle(T_map_hall.heading_rad() + std::atan2(side.y(), side.x())), 1.5 * std::numbers::pi});
  return edges;
}

/// Finds a thing somewhere else from each place.
class Restless final : public FeatureDetector {
 public:
  std::vector<Feature> detect(const Scan& scan) const override {
    if (scan.points.empty()) return {};
    return {{.type = "acme:Ghost", .geometry = scan.points[scan.points.size() / 3].position}};
  }
};

/// Two rooms of 5 m by 6 m, and in the wall between them a way of 1 m.
/// @param leaf  type of what stands in it, unperceived; empty: nothing does.
std::shared_ptr<const SemanticMap> two_rooms(const std::string& leaf) {
  std::vector<MapObject> objects{{"wall", "opal:Wall"}};
  std::vector<MapFeature> features;
  const auto face = [&](const Point& begin, const Point& end) {
    features.push_back({"face-" + std::to_string(features.size()), MapObjectNumber(0), "opal:Wall", "PlanarLidar2D",
                        Segment{begin, end}});
  };
  const auto outline = [&](const std::vector<Point>& corners) {
    for (std::size_t k = 0; k < corners.size(); ++k) face(corners[k], corners[(k + 1) % corners.size()]);
  };
  outline({{0, 0}, {10, 0}, {10, 6}, {0, 6}});
  outline({{4.95, 0}, {4.95, 2.5}, {5.05, 2.5}, {5.05, 0}});
  outline({{4.95, 3.5}, {4.95, 6}, {5.05, 6}, {5.05, 3.5}});
  if (leaf.empty()) return SemanticMap::make("two rooms", objects, features);
  objects.push_back({"door", leaf});
  features.push_back({"leaf", MapObjectNumber(1), "opal:Wall", "", Segment{{5, 2.5}, {5, 3.5}}});
  return SemanticMap::make("two rooms", objects, features);
}

/// Finds the middle of a gap of 0.8 m to 1.2 m between two things behind which all is farther away.
class GapDetector final : public FeatureDetector {
 public:
  std::vector<Feature> detect(const Scan& scan) const override {
    constexpr double kDeeper_m = 0.5;
    std::vector<Feature> gaps;
    const auto& points = scan.points;
    for (std::size_t a = 0; a + 1 < points.size(); ++a) {
      if (points[a + 1].range_m < points[a].range_m + kDeeper_m) continue;
      std::size_t b = a + 1;
      while (b < points.size() && points[b].range_m > points[a].range_m + kDeeper_m) ++b;
      if (b == points.size()) continue;
      const double width_m = (points[b].position - points[a].position).norm();
      if (width_m > 0.8 && width_m < 1.2)
        gaps.push_back({.type = "acme:Doorway", .geometry = Point(0.5 * (points[a].position + points[b].position))});
    }
    return gaps;
  }
};

}  // namespace

TEST_CASE("the edges of a pillar are derived where they are, and belong to it, wherever the map has its origin") {
  const Pose2 T_map_hall = GENERATE(Pose2(), Pose2(30, -12, 0.7));
  const auto map = Hall(T_map_hall).map();
  const Derivation derivation = derived_features(*map, boxes::BoxDetector({}), kPillarCorner);
  const std::vector<MapFeature> found = pillar_corners(*derivation.map);
  CHECK(derivation.added.size() == 4);
  CHECK(derivation.known == 0);
  REQUIRE(found.size() == 4);
  for (const OrientedPoint& edge : true_edges(T_map_hall)) {
    CAPTURE(edge.position.transpose());
    CHECK(std::count_if(found.begin(), found.end(), [&](const MapFeature& feature) {
            const auto& at = std::get<OrientedPoint>(feature.geometry);
            return (at.position - edge.position).norm() < 0.03 &&
                   std::abs(wrap_angle(at.heading_rad - edge.heading_rad)) < 0.05 &&
                   std::abs(at.opening_rad - edge.opening_rad) < 0.1;
          }) == 1);
  }
  for (const MapFeature& feature : found) {
    CHECK(derivation.map->object(feature.object).id == "pillar");
    CHECK(feature.sensor == "PlanarLidar2D");
    CHECK_THAT(feature.id, Contains("pillar/PillarCorner-"));
  }
}

TEST_CASE("what the map has keeps its name and place, and is not derived again") {
  const auto map = Hall().map();
  const Derivation once = derived_features(*map, boxes::BoxDetector({}), kPillarCorner);
  for (const MapFeature& feature : map->features())
    CHECK(std::any_of(once.map->features().begin(), once.map->features().end(), [&](const MapFeature& kept) {
      return kept.id == feature.id && kept.type == feature.type && kept.geometry.index() == feature.geometry.index();
    }));
  CHECK(once.map->features().size() == map->features().size() + once.added.size());
  const Derivation twice = derived_features(*once.map, boxes::BoxDetector({}), kPillarCorner);
  CHECK(twice.added.empty());
  CHECK(twice.known == once.added.size());
  CHECK(twice.map->features().size() == once.map->features().size());
}

TEST_CASE("what a detector finds at another place from each place is no feature of the building") {
  const std::vector<std::string> ghost{"acme:Ghost"};
  const Derivation derivation = derived_features(*Hall().map(), Restless(), ghost);
  CHECK(derivation.added.empty());
  CHECK(derivation.seldom + derivation.on_nothing > 0);
}

TEST_CASE("what stands in a doorway is derived if doors are open, and not if they are shut") {
  const auto map = two_rooms("opal:Door");
  const std::vector<std::string> type{"acme:Doorway"};
  DerivationOptions options;
  CHECK(derived_features(*map, GapDetector(), type, options).added.empty());
  options.doors_open = true;
  CHECK(derived_features(*map, GapDetector(), type, options).added == std::vector<std::string>{"door/Doorway-1"});
}

TEST_CASE("what is found beside every object is counted apart from what is seen too seldom") {
  const std::vector<std::string> type{"acme:Doorway"};
  const Derivation derivation = derived_features(*two_rooms(""), GapDetector(), type);
  CHECK(derivation.added.empty());
  CHECK(derivation.on_nothing > 0);
  CHECK(derivation.seldom == 0);
}

TEST_CASE("only the types that are asked for are derived") {
  const std::vector<std::string> other{"acme:Post"};
  CHECK(derived_features(*Hall().map(), boxes::BoxDetector({}), other).added.empty());
}

TEST_CASE("a type's prefix keeps the IRI that its author gave it") {
  class Post final : public FeatureDetector {
    std::vector<Feature> detect(const Scan& scan) const override {
      std::vector<Feature> edges = boxes::BoxDetector({}).detect(scan);
      for (Feature& edge : edges) edge.type = "acme:Post";
      return edges;
    }
  };
  const std::vector<std::string> post{"acme:Post"};
  const auto map = derived_features(*Hall().map(), Post(), post, {}, {{"acme", "https://acme.example/opal#"}}).map;
  CHECK(map->prefixes().at("acme") == "https://acme.example/opal#");
}

TEST_CASE("a pillar in a room behind a door that is shut is looked at, too") {
  const auto hall = Hall().map();
  std::vector<MapObject> objects = hall->objects();
  std::vector<MapFeature> features = hall->features();
  const MapObjectNumber door(objects.size());
  objects.push_back({"door", "opal:Door"});
  features.push_back({"door/leaf", door, "opal:Door", "", Segment{{6, 0}, {6, 8}}});
  objects.push_back({"far", "opal:Column"});
  const Point corners[] = {{7.8, 3.8}, {7.8, 4.2}, {8.2, 4.2}, {8.2, 3.8}};
  for (int k = 0; k < 4; ++k)
    features.push_back({"far/face-" + std::to_string(k), door.next(), "opal:Wall", "PlanarLidar2D",
                        Segment{corners[k], corners[(k + 1) % 4]}});
  const auto map = SemanticMap::make("two rooms", objects, features);
  CHECK(derived_features(*map, boxes::BoxDetector({}), kPillarCorner).added.size() == 8);
}

TEST_CASE("a building in which nobody can stand is an error") {
  DerivationOptions options;
  options.clearance_m = 20;
  CHECK_THROWS_AS(derived_features(*Hall().map(), boxes::BoxDetector({}), kPillarCorner, options), MapError);
}
