#include "drivable_floor.hpp"
#include "every_building.hpp"

#include <opal/common/error.hpp>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include "simulation/ray_caster.hpp"

using namespace opal;
using namespace opal::simulation;
using Catch::Contains;

namespace {

/// The same geometry, to the millimetre, wherever it stands.
using Shape = std::tuple<std::string, bool, std::vector<long>>;

Shape shape_of(const MapFeature& feature, double shift_m) {
  std::vector<long> numbers;
  const auto add = [&](const Point& p) {
    numbers.insert(numbers.end(), {std::lround(1e3 * (p.x() + shift_m)), std::lround(1e3 * p.y())});
  };
  if (const auto* face = std::get_if<Segment>(&feature.geometry)) add(face->begin), add(face->end);
  if (const auto* circle = std::get_if<Circle>(&feature.geometry)) {
    add(circle->center);
    numbers.push_back(std::lround(1e3 * circle->radius_m));
  }
  if (const auto* corner = std::get_if<OrientedPoint>(&feature.geometry)) {
    add(corner->position);
    numbers.insert(numbers.end(), {std::lround(1e3 * corner->heading_rad), std::lround(1e3 * corner->opening_rad)});
  }
  return {feature.type, feature.sensor.empty(), numbers};
}

/// Share of the features that have a copy so far along x.
double repeated_share(const SemanticMap& map, double shift_m) {
  std::set<Shape> shapes;
  for (const MapFeature& feature : map.features()) shapes.insert(shape_of(feature, 0));
  int repeated = 0;
  for (const MapFeature& feature : map.features()) repeated += shapes.contains(shape_of(feature, shift_m));
  return repeated / static_cast<double>(map.features().size());
}

}  // namespace

TEST_CASE("faces close: as many begin at a point as end there") {
  for (const BuildingRequest& request : every_building()) {
    INFO(request.kind << " seed " << request.seed << " size " << request.size_m2 << " symmetry " << request.symmetry);
    const Building building = generate_building(request);
    std::map<std::string, int> balance;
    for (const MapFeature& feature : building.map->features())
      if (std::holds_alternative<Segment>(feature.geometry)) {
        ++balance[feature.points[0]];
        --balance[feature.points[1]];
      }
    bool is_balanced = true;
    for (const auto& [point, number] : balance) is_balanced = is_balanced && number == 0;
    CHECK(is_balanced);
  }
}

TEST_CASE("a corner is where two perceived faces meet, open to their visible sides") {
  for (const BuildingRequest& request : every_building()) {
    INFO(request.kind << " seed " << request.seed << " size " << request.size_m2 << " symmetry " << request.symmetry);
    const Building building = generate_building(request);
    std::map<std::string, Segment> ending, beginning;
    for (const MapFeature& feature : building.map->features())
      if (const auto* face = std::get_if<Segment>(&feature.geometry); face && !feature.sensor.empty()) {
        beginning.emplace(feature.points[0], *face);
        ending.emplace(feature.points[1], *face);
      }
    int wrong = 0;
    for (const MapFeature& feature : building.map->features())
      if (const auto* corner = std::get_if<OrientedPoint>(&feature.geometry)) {
        REQUIRE(ending.contains(feature.points[0]));
        REQUIRE(beginning.contains(feature.points[0]));
        const Segment &before = ending.at(feature.points[0]), &after = beginning.at(feature.points[0]);
        const double opening = std::numbers::pi - wrap_angle(after.heading_rad() - before.heading_rad());
        const double off = wrap_angle(corner->heading_rad - after.heading_rad() - opening / 2);
        wrong += std::abs(opening - corner->opening_rad) > 1e-9 || std::abs(off) > 1e-9;
      }
    CHECK(wrong == 0);
  }
}

TEST_CASE("from the visible side of every face a beam meets something: nothing leads out of the building") {
  for (const BuildingRequest& request : every_building()) {
    INFO(request.kind << " seed " << request.seed << " size " << request.size_m2 << " symmetry " << request.symmetry);
    const Building building = generate_building(request);
    std::vector<Solid> solids;
    for (const MapFeature& feature : building.map->features()) solids.push_back({feature.geometry, false});
    const RayCaster caster(solids);
    int lost = 0, from_behind = 0;
    for (const MapFeature& feature : building.map->features()) {
      const auto* face = std::get_if<Segment>(&feature.geometry);
      if (!face) continue;
      if (feature.id.find("/leaf-") != std::string::npos) continue;  // its ends touch the jambs
      const Point start =
          face->begin + 0.1 * (face->end - face->begin) + 1e-3 * face->normal();  // beside a leaf that is there
      for (int k = -4; k <= 4; ++k) {
        const Point way = unit_vector(face->heading_rad() + std::numbers::pi * (0.5 + 0.11 * k));
        const RayHit hit = caster.cast(start, way, 1e3);
        if (hit.solid < 0) {
          ++lost;
          continue;
        }
        const auto* met = std::get_if<Segment>(&caster.solids()[static_cast<std::size_t>(hit.solid)].shape);
        from_behind += met && met->normal().dot(way) > 1e-9;
      }
    }
    CHECK(lost == 0);
    CHECK(from_behind == 0);
  }
}

TEST_CASE("a robot of 0.7 m reaches nearly all of the floor while doors are open") {
  for (const BuildingRequest& request : every_building()) {
    INFO(request.kind << " seed " << request.seed << " size " << request.size_m2 << " symmetry " << request.symmetry);
    const DrivableFloor floor(*generate_building(request).map, 0.35, 0.05);
    CHECK(floor.covered_share() > 0.95);
    CHECK_FALSE(floor.places().empty());
  }
}

TEST_CASE("the map check finds nothing odd but leaves and panes that no sensor perceives") {
  for (const BuildingRequest& request : every_building()) {
    INFO(request.kind << " seed " << request.seed << " size " << request.size_m2 << " symmetry " << request.symmetry);
    for (const std::string& warning : check_map(*generate_building(request).map).warnings)
      CHECK_THAT(warning, Contains("that no sensor perceives"));
  }
}

TEST_CASE("what no sensor perceives is a door's leaf or a pane") {
  for (const BuildingRequest& request : every_building()) {
    const Building building = generate_building(request);
    for (const MapFeature& feature : building.map->features()) {
      if (!feature.sensor.empty()) continue;
      const std::string& type = building.map->object(feature.object).type;
      CHECK((type == "opal:Door" || type == "opal:Window"));
    }
  }
}

TEST_CASE("the same seed gives the same document, and another one another") {
  for (BuildingRequest request : every_building()) {
    INFO(request.kind << " seed " << request.seed << " size " << request.size_m2 << " symmetry " << request.symmetry);
    const std::string document = document_of(*generate_building(request).map);
    CHECK(document == document_of(*generate_building(request).map));
    CHECK(document == document_of(*SemanticMap::parse(document, "generated")));
    if (request.size_m2 == 0) continue;
    request.seed += 100;
    CHECK(document != document_of(*generate_building(request).map));
  }
}

TEST_CASE("symmetry makes parts repeat") {
  for (const BuildingKind& kind : building_kinds()) {
    if (kind.usual_size_m2 == 0) continue;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      INFO(kind.name << " seed " << seed);
      const Building same = generate_building({kind.name, seed, 3 * kind.usual_size_m2, 1});
      const Building different = generate_building({kind.name, seed, 3 * kind.usual_size_m2, 0});
      CHECK(repeated_share(*same.map, same.module_m) > 0.5);
      CHECK(repeated_share(*different.map, different.module_m) < 0.2);
    }
  }
}

TEST_CASE("buildings are about as large as asked for") {
  for (const BuildingRequest& request : every_building()) {
    if (request.size_m2 == 0) continue;
    INFO(request.kind << " seed " << request.seed << " size " << request.size_m2 << " symmetry " << request.symmetry);
    const MapCheck check = check_map(*generate_building(request).map);
    const Point extent = check.bounds[1] - check.bounds[0];
    CHECK(extent.x() * extent.y() > 0.5 * request.size_m2);
    CHECK(extent.x() * extent.y() < 2.5 * request.size_m2);
  }
}

TEST_CASE("what cannot be built is refused by name") {
  CHECK_THROWS_WITH(generate_building({"castle"}), Contains("\"castle\"") && Contains("atlas, gemini, office"));
  CHECK_THROWS_WITH(generate_building({"office", 1, 5}), Contains("5 m^2") && Contains("100 to 100000"));
  CHECK_THROWS_WITH(generate_building({"office", 1, std::nan("")}), Contains("nan"));
  CHECK_THROWS_WITH(generate_building({"office", 1, 500, 1.5}), Contains("1.5"));
}

TEST_CASE("floor that nobody can get to is not drivable") {
  const auto room = [](double left, double right, std::vector<MapFeature>& features) {
    const Point a(left, 0), b(right, 0), c(right, 4), d(left, 4);
    for (const Segment& face : {Segment{a, b}, Segment{b, c}, Segment{c, d}, Segment{d, a}})
      features.push_back(
          {"face-" + std::to_string(features.size()), MapObjectNumber(0), "opal:Wall", "PlanarLidar2D", face});
  };
  std::vector<MapFeature> features;
  room(0, 6, features);
  room(7, 10, features);
  const auto map = SemanticMap::make("two rooms", {{"walls", "opal:Wall"}}, features);
  const DrivableFloor floor(*map, 0.35, 0.05);
  CHECK(floor.can_stand({3, 2}));
  CHECK_FALSE(floor.can_stand({0.2, 2}));
  CHECK_FALSE(floor.can_stand({8.5, 2}));
  CHECK(floor.floor_m2() == Approx(36).epsilon(0.05));
  CHECK(floor.covered_m2() == Approx(24).epsilon(0.05));
}
