#include <opal/common/error.hpp>
#include <opal/plugin/testing/scorer_contract.hpp>
#include "map_tools/map_join.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <random>
#include <set>

using namespace opal;

namespace {

std::vector<MapSourcePart> sources(int count) {
  std::vector<MapSourcePart> parts;
  for (int k = 0; k < count; ++k) parts.push_back({"hall-" + std::to_string(k + 1), testing::example_map()});
  return parts;
}

std::shared_ptr<const SemanticMap> joined(int count, int copies = 0, std::uint64_t seed = 1) {
  return joined_map(sources(count), {20, copies, seed});
}

const MapFeature& named(const SemanticMap& map, const std::string& id) {
  for (const MapFeature& feature : map.features())
    if (feature.id == id) return feature;
  throw std::runtime_error("no feature " + id);
}

double far_apart_m(const Geometry& a, const Geometry& b) {
  REQUIRE(a.index() == b.index());
  if (const auto* s = std::get_if<Segment>(&a)) {
    const auto& t = std::get<Segment>(b);
    return std::max((s->begin - t.begin).norm(), (s->end - t.end).norm());
  }
  double off = (anchor_of(a) - anchor_of(b)).norm();
  if (const auto* c = std::get_if<Circle>(&a)) off += std::abs(c->radius_m - std::get<Circle>(b).radius_m);
  if (const auto* c = std::get_if<OrientedPoint>(&a))
    off += std::abs(wrap_angle(c->heading_rad - std::get<OrientedPoint>(b).heading_rad)) +
           std::abs(c->opening_rad - std::get<OrientedPoint>(b).opening_rad);
  return off;
}

/// The corner that a chain of faces has where `before` ends and `after` begins.
OrientedPoint corner_between(const Segment& before, const Segment& after) {
  const double turn_rad = wrap_angle(after.heading_rad() - before.heading_rad());
  const double opening_rad = std::numbers::pi - turn_rad;
  return {after.begin, wrap_angle(after.heading_rad() + opening_rad / 2), opening_rad};
}

}  // namespace

TEST_CASE("a join of one map is that map, moved") {
  const auto map = testing::example_map(), moved = joined(1);
  REQUIRE(moved->features().size() == map->features().size());
  REQUIRE(moved->objects().size() == map->objects().size());
  const MapPlacement& placement = placement_of(*moved, "hall-1");
  CHECK(placement.is_rigid());
  for (const MapFeature& feature : map->features()) {
    const MapFeature& there = named(*moved, "hall-1/" + feature.id);
    CHECK(far_apart_m(there.geometry, transformed(placement.T_map_source, feature.geometry)) < 1e-9);
    CHECK(there.type == feature.type);
    CHECK(moved->object(there.object).id == "hall-1/" + map->object(feature.object).id);
  }
}

TEST_CASE("joined maps and their copies keep apart, and no two things have one id") {
  const auto map = joined(3, 2);
  const auto once = testing::example_map();
  CHECK(map->features().size() == 9 * once->features().size());
  CHECK(map->origin().placements.size() == 9);
  std::map<std::string, std::array<Point, 2>> bounds;
  for (const MapPlacement& placement : map->origin().placements)
    for (const MapFeature& feature : once->features()) {
      const Point p = anchor_of(named(*map, placement.id + "/" + feature.id).geometry);
      auto [box, is_new] = bounds.try_emplace(placement.id, std::array<Point, 2>{p, p});
      box->second = {box->second[0].cwiseMin(p), box->second[1].cwiseMax(p)};
    }
  for (const auto& [a, box_a] : bounds)
    for (const auto& [b, box_b] : bounds) {
      if (a == b) continue;
      const Point gap = (box_a[0] - box_b[1]).cwiseMax(box_b[0] - box_a[1]);
      CAPTURE(a, b);
      CHECK(gap.maxCoeff() >= 20 - 1e-9);
    }
}

TEST_CASE("copies are the same for the same seed, and others for another") {
  CHECK(joined(2, 3, 5)->to_json_ld() == joined(2, 3, 5)->to_json_ld());
  CHECK(joined(2, 3, 5)->to_json_ld() != joined(2, 3, 6)->to_json_ld());
}

TEST_CASE("copies are mirrored and stretched by 5 to 30 per cent, with what can be seen on the same side") {
  const auto map = joined(1, 10, GENERATE(range(1u, 6u)));
  const auto once = testing::example_map();
  std::set<double> stretches;
  for (const MapPlacement& placement : map->origin().placements) {
    if (placement.id == "hall-1") continue;
    CHECK(placement.scale.x() < 0);
    for (const double stretch : {-placement.scale.x(), placement.scale.y()}) {
      CHECK(stretch >= 1.05);
      CHECK(stretch <= 1.30);
      stretches.insert(stretch);
    }
    for (const MapFeature& feature : once->features()) {
      const auto* face = std::get_if<Segment>(&feature.geometry);
      if (!face) continue;
      const auto& there = std::get<Segment>(named(*map, placement.id + "/" + feature.id).geometry);
      const Point seen_from = placement.to_map(face->midpoint() + 0.1 * face->normal());
      CHECK(there.normal().dot(seen_from - there.midpoint()) > 0);
    }
  }
  CHECK(stretches.size() == 20);
}

TEST_CASE("a placed corner is the corner of its placed faces") {
  std::mt19937 random(GENERATE(range(1u, 40u)));
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const MapPlacement placement{"x", Pose2(uniform(-9, 9), uniform(-9, 9), uniform(-3, 3)),
                               Point(uniform(0, 1) < 0.5 ? 1.2 : -1.2, uniform(0.8, 1.3))};
  const Point middle(uniform(-5, 5), uniform(-5, 5));
  const Segment before{middle + 3 * unit_vector(uniform(-3, 3)), middle};
  const Segment after{middle, middle + 2 * unit_vector(before.heading_rad() + uniform(-2.5, 2.5))};
  auto first = std::get<Segment>(placed(placement, before)), second = std::get<Segment>(placed(placement, after));
  if (placement.scale.x() < 0) std::swap(first, second);
  CHECK(far_apart_m(placed(placement, corner_between(before, after)), corner_between(first, second)) < 1e-9);
}

TEST_CASE("a joined map is written and read with its placements") {
  const auto map = joined(2, 1);
  CHECK(SemanticMap::parse(map->to_json_ld().dump(), "joined")->to_json_ld() == map->to_json_ld());
}

TEST_CASE("what cannot be joined is refused with the reason") {
  CHECK_THROWS_WITH(joined(0), Catch::Contains("no maps"));
  CHECK_THROWS_WITH(joined(1, -1), Catch::Contains("-1 copies, expected 0 to 1000"));
  CHECK_THROWS_WITH(joined_map(sources(1), {-1, 0, 1}), Catch::Contains("expected metres from 0 to 10000"));
  auto twins = sources(2);
  twins[1].prefix = twins[0].prefix;
  CHECK_THROWS_WITH(joined_map(twins, {}), Catch::Contains("two maps are called 'hall-1'"));
  CHECK_THROWS_WITH(joined_map(std::vector<MapSourcePart>{{"both", joined(2)}}, {}),
                    Catch::Contains("is a joined map"));
  CHECK_THROWS_WITH(placement_of(*joined(2), "hall-3"), Catch::Contains("expected one of: hall-1, hall-2"));
  const auto empty = SemanticMap::make("empty", {}, {});
  CHECK_THROWS_WITH(joined_map(std::vector<MapSourcePart>{{"empty", empty}}, {}), Catch::Contains("has no features"));
}

TEST_CASE("the axis of a wall lies where the wall lies") {
  const auto map =
      SemanticMap::make("hall", {{"wall", "opal:Wall", {}, {.axis = Segment{{0, 0.1}, {4, 0.1}}}}},
                        {{"wall/face", MapObjectNumber(0), "opal:Wall", "PlanarLidar2D", Segment{{0, 0}, {4, 0}}}});
  const std::vector<MapSourcePart> parts{{"a", map}, {"b", map}};
  const auto joined = joined_map(parts, {});
  for (const MapFeature& feature : joined->features()) {
    const Segment& face = std::get<Segment>(feature.geometry);
    const std::optional<Segment>& axis = joined->object(feature.object).notes.axis;
    REQUIRE(axis);
    CHECK((axis->begin - face.begin - Point(0, 0.1)).norm() < 1e-9);
    CHECK((axis->end - face.end - Point(0, 0.1)).norm() < 1e-9);
  }
}
