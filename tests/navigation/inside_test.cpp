#include "navigation/actions.hpp"
#include "navigation/path_drive.hpp"
#include "synthetic.hpp"
#include "tests/kit/sanitized.hpp"

#include "map_tools/building_outside.hpp"
#include "map_tools/map_stack.hpp"

#include <catch2/catch.hpp>

#include <ctime>

using namespace opal;
using namespace opal::navigation;

namespace {

/// A building of walls 0.2 m thick, seen from both sides, 8 m x 6 m, with a doorway of that width in the middle of its
/// right side.
std::vector<Segment> house(double doorway_m) {
  const double low = 3 - doorway_m / 2, high = 3 + doorway_m / 2;
  // clang-format off
  return room_of({{0, 0}, {8, 0}, {8, low}, {8.2, low}, {8.2, -0.2}, {-0.2, -0.2}, {-0.2, 6.2}, {8.2, 6.2},
                  {8.2, high}, {8, high}, {8, 6}, {0, 6}});
  // clang-format on
}

int outside_of(const std::vector<char>& cells, const MapRaster& raster, const Point& p) {
  const Point cell = (p - raster.origin) / raster.resolution_m;
  return cells[static_cast<std::size_t>(cell.y()) * raster.columns + static_cast<std::size_t>(cell.x())];
}

/// A map of faces, and a leaf in the doorway that nothing perceives.
std::shared_ptr<const SemanticMap> with_leaf(const std::vector<Segment>& faces, const Segment& leaf) {
  std::vector<MapObject> objects{{"house", "opal:Wall"}, {"door", "opal:Door"}};
  std::vector<MapFeature> features;
  for (const Segment& face : faces)
    features.push_back(
        {"face-" + std::to_string(features.size()), MapObjectNumber(0), "opal:Wall", "PlanarLidar2D", face});
  features.push_back({"leaf", MapObjectNumber(1), "opal:Door", "", leaf});
  return SemanticMap::make("house", std::move(objects), std::move(features));
}

}  // namespace

TEST_CASE("what lies before the outer walls is outside, whatever the doors do") {
  const auto map = GENERATE(as<std::shared_ptr<const SemanticMap>>{}, map_of(house(1)), map_of(house(3)),
                            with_leaf(house(5.9), {{8.1, 0.05}, {8.1, 5.95}}));
  const MapRaster raster = floor_raster(*map);
  const std::vector<char> outside = outside_cells(*map, raster);
  for (const Point& p : {Point(1, 1), Point(4, 3), Point(6.5, 3), Point(7, 5)})
    CHECK_FALSE(outside_of(outside, raster, p));
  for (const Point& p : {Point(8.8, 3), Point(4, -0.8), Point(-0.8, 6.8)}) CHECK(outside_of(outside, raster, p));
}

TEST_CASE("a map of walls that enclose nothing is inside between them, and outside around them") {
  const auto map = map_of({{{0, 0}, {8, 0}}, {{9, 3}, {9, 9}}});
  const MapRaster raster = floor_raster(*map);
  const std::vector<char> outside = outside_cells(*map, raster);
  for (const Point& p : {Point(4, 1), Point(8, 3), Point(8.8, 6)}) CHECK_FALSE(outside_of(outside, raster, p));
  for (const Point& p : {Point(4, -0.5), Point(9.5, 6), Point(1, 7)}) CHECK(outside_of(outside, raster, p));
}

TEST_CASE("storeys are looked over in seconds, each as if it were alone") {
  std::vector<StoreyPart> parts;
  for (int k = 0; k < 9; ++k) parts.push_back({"storey-" + std::to_string(k), "", {}, map_of(house(1))});
  const auto map = stacked_map("tower", parts).map;
  const MapRaster raster = floor_raster(*map);
  const std::clock_t before = std::clock();
  const std::vector<char> outside = outside_cells(*map, raster);
  if (!kIsSanitized) CHECK(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC < 5);
  for (const MapStorey& storey : map->origin().storeys) {
    for (const Point& p : {Point(1, 1), Point(4, 3), Point(6.5, 3), Point(7, 5)})
      CHECK_FALSE(outside_of(outside, raster, storey.origin + p));
    for (const Point& p : {Point(8.8, 3), Point(4, -0.8), Point(-0.8, 6.8)})
      CHECK(outside_of(outside, raster, storey.origin + p));
  }
  CHECK(outside_of(outside, raster, map->origin().storeys.front().origin + Point(60, 60)));
}

TEST_CASE("a porch between two wings of a house is outside") {
  // clang-format off
  std::vector<Segment> faces = room_of({{-0.2, -0.2}, {-0.2, 8.2}, {10.2, 8.2}, {10.2, -0.2}, {6.2, -0.2}, {6.2, 3},
                                        {3.8, 3}, {3.8, -0.2}});
  for (const Segment& face : room_of({{0, 0}, {3.6, 0}, {3.6, 3.2}, {6.4, 3.2}, {6.4, 0}, {10, 0}, {10, 8}, {0, 8}}))
    faces.push_back(face);
  // clang-format on
  const auto map = map_of(faces);
  const MapRaster raster = floor_raster(*map);
  const std::vector<char> outside = outside_cells(*map, raster);
  CHECK(outside_of(outside, raster, {5, 2.5}));
  CHECK_FALSE(outside_of(outside, raster, {5, 5}));
}

TEST_CASE("no way leads out of the building, and one from outside leads in") {
  const MapView map(map_of(house(1)), "PlanarLidar2D");
  const FloorGrid floor = mapped_floor(map, 0.25);
  const Point inside(4, 3), elsewhere(1, 5), outside(8.9, 3);
  REQUIRE(floor.is_outside(outside));
  CHECK(floor.way(inside, elsewhere));
  CHECK_FALSE(floor.way(inside, outside));
  CHECK(floor.way(outside, inside));
}

TEST_CASE("two flats of one building are both floor, and no way leads from one to the other") {
  std::vector<Segment> faces = room_of({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  for (const Segment& face : room_of({{5, 0}, {9, 0}, {9, 4}, {5, 4}})) faces.push_back(face);
  const MapView map(map_of(faces), "PlanarLidar2D");
  const FloorGrid floor = mapped_floor(map, 0.25);
  CHECK(floor.way({1, 1}, {3, 2}));
  CHECK(floor.way({6, 1}, {8, 3}));
  CHECK_FALSE(floor.way({1, 1}, {8, 3}));
}

TEST_CASE("a way is made straight where nothing is in between, and not through walls") {
  const MapView map(map_of(room_of({{0, 0}, {8, 0}, {8, 6}, {4.2, 6}, {4.2, 2}, {3.8, 2}, {3.8, 6}, {0, 6}})),
                    "PlanarLidar2D");
  const FloorGrid floor = mapped_floor(map, 0.25);
  const auto free = floor.way({1, 1}, {7, 1.3});
  REQUIRE(free);
  CHECK(floor.straightened(*free).size() < 6);
  const auto round = floor.way({2, 5}, {6, 5});
  REQUIRE(round);
  const std::vector<Point> straight = floor.straightened(*round);
  CHECK(straight.size() < round->size() / 3);
  CHECK(straight.front() == round->front());
  CHECK(straight.back() == round->back());
  for (std::size_t k = 0; k + 1 < straight.size(); ++k) CHECK(floor.holds(straight[k], straight[k + 1]));
}

TEST_CASE("what stands on the border of cells makes dear all floor around it") {
  const FloorGrid grid({0, 0}, 0.1, 300, 300, std::vector<char>(300 * 300, 1));
  for (int k = 0; k < 200; ++k) {
    const Point p = 0.1 * Point(20 + k, 250 - k);
    FloorGrid::Surcharge prices = grid.no_surcharge();
    grid.raise(prices, std::vector<Point>{p}, 0.38, 1);
    CHECK(std::count(prices.begin(), prices.end(), 1.f) == 44);
  }
}

TEST_CASE("a robot that sees nothing any more goes back to where it saw something") {
  SyntheticMoment moment;
  DriveFreely drive(0);
  double now_s = 0;
  const auto at = [&](double x) {
    moment.queries.stand(Pose2(x, 3, 0), {}, now_s += 0.5);
    moment.queries.said = {};
    if (x > 8.5) moment.queries.scan.points.clear();  // the synthetic walls are seen from inside only
    moment.blackboard.look();
  };
  for (double x = 2; x < 30; x += 0.5) at(x);
  REQUIRE(drive.tick(moment.blackboard) == NodeStatus::running);
  CHECK(moment.blackboard.velocity().linear_mps.x() < 0.3);
  CHECK(std::abs(moment.blackboard.velocity().turn_radps) > 0.3);  // what it knows lies behind it
}

TEST_CASE("a robot that searches keeps away from where its hypotheses have the building end") {
  SyntheticMoment moment(map_of(house(1)));
  DriveFreely drive(0);
  moment.queries.stand(Pose2(7.4, 3, 0), {Pose2(7.4, 3, 0)}, 1);
  moment.blackboard.look();
  REQUIRE(drive.tick(moment.blackboard) == NodeStatus::running);
  CHECK(moment.blackboard.velocity().linear_mps.x() < 0.3);  // not on through the doorway ahead
}

TEST_CASE("a plan remembers what stands in the way when the robot is far from it again") {
  const auto map = map_of(room_of({{0, 0}, {30, 0}, {30, 3}, {0, 3}}));
  SyntheticMoment moment(map);
  const auto look_from = [&](double x, bool barred, double now_s) {
    moment.queries.stand(Pose2(x, 1.5, 0), {Pose2(x, 1.5, 0)}, now_s);
    if (barred) moment.queries.scan.points.push_back({{4, 0}, 4, 0, 270});
    moment.blackboard.look();
  };
  for (const double now_s : {1.0, 1.6, 2.2}) look_from(2, true, now_s);
  REQUIRE(moment.blackboard.unmapped().size() == 1);
  look_from(20, false, 40);
  CHECK(moment.blackboard.unmapped().size() == 1);
}

TEST_CASE("somebody who walked by is not planned around a minute later") {
  SeenObstacles seen;
  const auto look = [&](double ahead_m, double stamp_s) {
    Scan scan{stamp_s, 0.01, 30, {}, {}};
    for (int k = -5; k <= 5; ++k) scan.points.push_back({ahead_m * unit_vector(0.01 * k), ahead_m, 0.01 * k, k + 5});
    seen.add(scan, Pose2(), Pose2());
  };
  look(3, 0);
  look(1.5, 0.6);  // nearer than what was behind
  CHECK(seen.moving(10).size() > 0);
  const Scan nothing{60, 0.01, 30, {}, {}};
  seen.add(nothing, Pose2(0, 0, 3), Pose2());  // the laser looks the other way
  CHECK(seen.moving(10).empty());
  const std::vector<Point> later = seen.standing(10);
  CHECK(std::none_of(later.begin(), later.end(), [](const Point& p) { return p.norm() < 2; }));
}

TEST_CASE("a way round 500 m long is better than past what stands in a gap that just fits, and who walks bars no way") {
  SyntheticMoment moment(map_of(room_of({{0, 0}, {30, 0}, {30, 3}, {0, 3}})));
  const double needed_m = moment.blackboard.motion.options().radius_m + moment.blackboard.motion.options().margin_m;
  const auto price_beside = [&](bool somebody, double now_s) {
    moment.queries.stand(Pose2(10, 1.5, 0), {Pose2(10, 1.5, 0)}, now_s);
    for (ScanPoint& p : moment.queries.scan.points)
      if (somebody && std::abs(p.bearing_rad) < 0.1) p = {2 * unit_vector(p.bearing_rad), 2, p.bearing_rad, p.beam};
    moment.blackboard.look();
    const FloorGrid& floor = moment.blackboard.floor;
    return unmapped_surcharge(moment.blackboard)[static_cast<std::size_t>(floor.cell_at({12.2 - needed_m, 1.5}))];
  };
  CHECK(price_beside(false, 0) < 1);
  const float walking = price_beside(true, 0.6);
  CHECK(walking > 5);
  CHECK(walking < 50);
  for (double now_s = 0.7; now_s < 15; now_s += 0.1) price_beside(true, now_s);
  CHECK(price_beside(true, 15) < 50);  // whoever has come may go on
  for (double now_s = 15.1; now_s < 25; now_s += 0.1) price_beside(true, now_s);
  CHECK(price_beside(true, 25) > 500);
}
