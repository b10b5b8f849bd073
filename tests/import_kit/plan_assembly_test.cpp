#include <opal/import_kit/plan_assembly.hpp>

#include <opal/common/error.hpp>
#include "map/check/map_check.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;

namespace {

PlanElement wall(const std::string& id, std::vector<Point> points, bool closed = false,
                 PlanSides sides = PlanSides::to_find) {
  return {id, "opal:Wall", "PlanarLidar2D", {{std::move(points), closed, sides}}};
}

PlanElement column(const std::string& id, const Point& centre, double radius_m) {
  return {id, "opal:Column", "PlanarLidar2D", {}, {{centre, radius_m}}};
}

std::vector<Point> box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

PlanAssembly assembled(const std::vector<PlanElement>& elements) { return assemble_plan("plan.dxf", "plan", elements); }

std::vector<Segment> faces(const PlanAssembly& assembly) {
  std::vector<Segment> all;
  for (const MapFeature& feature : assembly.map->features())
    if (const auto* segment = std::get_if<Segment>(&feature.geometry)) all.push_back(*segment);
  return all;
}

std::vector<OrientedPoint> corners(const PlanAssembly& assembly) {
  std::vector<OrientedPoint> all;
  for (const MapFeature& feature : assembly.map->features())
    if (const auto* corner = std::get_if<OrientedPoint>(&feature.geometry)) all.push_back(*corner);
  return all;
}

bool has(const std::vector<Segment>& faces, const Point& begin, const Point& end) {
  return std::any_of(faces.begin(), faces.end(), [&](const Segment& face) {
    return (face.begin - begin).norm() < 0.011 && (face.end - end).norm() < 0.011;
  });
}

}  // namespace

TEST_CASE("two lines side by side are the faces of one wall, and its ends close it") {
  const PlanAssembly plan =
      assembled({wall("a", {{0, 0}, {5, 0}}), wall("b", {{0, 0.2}, {5, 0.2}}), wall("c", {{5, 0}, {5, 0.2}})});
  const auto found = faces(plan);
  CHECK(found.size() == 3);
  CHECK(has(found, {5, 0}, {0, 0}));
  CHECK(has(found, {0, 0.2}, {5, 0.2}));
  CHECK(has(found, {5, 0.2}, {5, 0}));
  CHECK(corners(plan).size() == 2);
  CHECK(plan.tally.pairs_m == Approx(10.2));
  CHECK(plan.tally.two_sided_m == 0);
}

TEST_CASE("a line alone is seen from both sides, and ends in no corner") {
  const PlanAssembly plan = assembled({wall("a", {{0, 0}, {5, 0}}), wall("b", {{0, 2}, {5, 2}})});
  CHECK(faces(plan).size() == 4);
  CHECK(corners(plan).empty());
  CHECK(plan.tally.two_sided_m == Approx(10));
}

TEST_CASE(
    "an outline of something thin is a wall seen from outside, an outline of a room alone is seen from both sides") {
  const PlanAssembly thin = assembled({wall("a", box(0, 0, 5, 0.2), true)});
  CHECK(faces(thin).size() == 4);
  CHECK(has(faces(thin), {5, 0}, {0, 0}));
  REQUIRE(corners(thin).size() == 4);
  for (const OrientedPoint& corner : corners(thin)) CHECK(corner.opening_rad == Approx(1.5 * std::numbers::pi));
  CHECK(faces(assembled({wall("a", box(0, 0, 5, 4), true)})).size() == 8);
}

TEST_CASE("between the outline of a building and those of its rooms there is wall") {
  const PlanAssembly plan =
      assembled({wall("outside", box(0, 0, 10, 6), true), wall("west", box(0.3, 0.3, 4.9, 5.7), true),
                 wall("east", box(5.0, 0.3, 9.7, 5.7), true)});
  const auto found = faces(plan);
  CHECK(found.size() == 12);
  CHECK(has(found, {10, 0}, {0, 0}));         // from outside
  CHECK(has(found, {0.3, 0.3}, {4.9, 0.3}));  // from inside
  CHECK(has(found, {4.9, 0.3}, {4.9, 5.7}));
  CHECK(corners(plan).size() == 12);
  CHECK(plan.tally.two_sided_m == 0);
}

TEST_CASE("walls drawn across each other leave nothing inside the joint") {
  const PlanAssembly plan = assembled({wall("a", {{0, 2}, {6, 2}}), wall("b", {{0, 2.2}, {6, 2.2}}),
                                       wall("c", {{3, 0}, {3, 5}}), wall("d", {{3.2, 0}, {3.2, 5}})});
  CHECK(faces(plan).size() == 8);
  CHECK(corners(plan).size() == 4);
  CHECK(plan.tally.hidden_m == Approx(0.8));
}

TEST_CASE("a wall that ends at another one opens its face there") {
  const PlanAssembly plan = assembled({wall("a", {{0, 0}, {6, 0}}), wall("b", {{0, 0.2}, {6, 0.2}}),
                                       wall("c", {{3, 0.2}, {3, 4}}), wall("d", {{3.1, 0.2}, {3.1, 4}})});
  const auto found = faces(plan);
  CHECK(found.size() == 5);
  CHECK(has(found, {0, 0.2}, {3, 0.2}));
  CHECK(has(found, {3.1, 0.2}, {6, 0.2}));
  CHECK(corners(plan).size() == 2);
}

TEST_CASE("at an opening both ends of the wall are seen, and nothing closes the opening") {
  const PlanAssembly plan = assembled({wall("w", box(0, 0, 2, 0.3), true), wall("e", box(2.5, 0, 5, 0.3), true)});
  CHECK(faces(plan).size() == 8);
  CHECK(has(faces(plan), {2, 0.3}, {2, 0}));
  CHECK(has(faces(plan), {2.5, 0}, {2.5, 0.3}));
  const PlanAssembly lines =
      assembled({wall("a", {{0, 0}, {2, 0}, {2, 0.2}, {0, 0.2}}), wall("b", {{5, 0}, {2.5, 0}, {2.5, 0.2}, {5, 0.2}})});
  CHECK(has(faces(lines), {2, 0.2}, {2, 0}));
  CHECK(faces(lines).size() == 6);
}

TEST_CASE("a niche between thin walls stays open, and a cavity in a wall is wall") {
  const auto open_to_the_right = [](double thickness, double gap) {
    // Two walls along x with their ends at 1, and between them the back of the niche at 0.
    const double a = 0, b = thickness, c = thickness + gap, d = 2 * thickness + gap;
    return assembled({wall("a", {{0, a}, {1, a}}), wall("b", {{0, b}, {1, b}}), wall("c", {{0, c}, {1, c}}),
                      wall("d", {{0, d}, {1, d}}), wall("ab", {{1, a}, {1, b}}), wall("cd", {{1, c}, {1, d}}),
                      wall("back", {{0, a}, {0, d}})});
  };
  for (const auto& [thickness, gap] : {std::pair{0.137, 0.508}, {0.1, 0.4}, {0.05, 0.32}}) {
    CAPTURE(thickness, gap);
    const auto niche = faces(open_to_the_right(thickness, gap));
    CHECK(has(niche, {0, thickness}, {1, thickness}));
    CHECK(has(niche, {1, thickness + gap}, {0, thickness + gap}));
    CHECK(has(niche, {1, 0}, {0, 0}));
    CHECK(has(niche, {0, 2 * thickness + gap}, {1, 2 * thickness + gap}));
  }
  for (const auto& [thickness, gap] : {std::pair{0.1, 0.25}, {0.2, 0.1}, {0.2, 0.25}}) {
    CAPTURE(thickness, gap);
    const PlanAssembly cavity = open_to_the_right(thickness, gap);
    CHECK_FALSE(has(faces(cavity), {0, thickness}, {1, thickness}));
  }
}

TEST_CASE("solid outlines that overlap or touch are one, and holes are seen from inside") {
  const PlanAssembly overlap = assembled(
      {wall("a", box(0, 0, 5, 0.3), true, PlanSides::solid), wall("b", box(4.7, 0, 5, 4), true, PlanSides::solid)});
  CHECK(faces(overlap).size() == 6);
  CHECK(corners(overlap).size() == 6);
  const PlanAssembly touching = assembled(
      {wall("a", box(0, 0, 2, 1), true, PlanSides::solid), wall("b", box(2, 0, 4, 1), true, PlanSides::solid)});
  CHECK(touching.tally.hidden_m == Approx(1));
  PlanElement ring = wall("r", box(0, 0, 8, 8), true, PlanSides::solid);
  ring.lines.push_back({box(1, 1, 7, 7), true, PlanSides::solid});
  const auto found = faces(assembled({ring}));
  CHECK(has(found, {1, 1}, {7, 1}));
  CHECK(has(found, {8, 0}, {0, 0}));
}

TEST_CASE("what is drawn twice or in pieces is one face, and it is said whose") {
  const PlanAssembly plan = assembled(
      {wall("a", {{0, 0}, {3, 0}}), wall("b", {{2, 0}, {5, 0.004}}), wall("twice", {{3, 0.002}, {0, 0.001}})});
  CHECK(faces(plan).size() == 2);
  CHECK(has(faces(plan), {0, 0}, {5, 0}));
  CHECK(plan.outcomes[0].status == PlanOutcome::Status::mapped);
  CHECK(plan.outcomes[1].status == PlanOutcome::Status::merged);
  CHECK(plan.outcomes[1].with == "a");
  CHECK(plan.outcomes[2].with == "a");
}

TEST_CASE("ends within a centimetre share their point") {
  const PlanAssembly plan = assembled({wall("a", {{0, 0}, {3, 0}}, false, PlanSides::both),
                                       wall("b", {{3.006, 0.005}, {3, 4}}, false, PlanSides::both)});
  CHECK(corners(plan).size() == 2);
  CHECK(check_map(*plan.map).shared_points >= 3);
  CHECK(check_map(*plan.map).warnings.empty());
}

TEST_CASE("a round column in a wall takes the wall's place, twice the same column is one") {
  const PlanAssembly plan = assembled({wall("w", box(0, 0, 5, 0.2), true, PlanSides::solid), column("c", {2, 0.1}, 0.3),
                                       column("again", {2.001, 0.1}, 0.3), column("inside", {4, 0.1}, 0.05)});
  CHECK(faces(plan).size() == 6);
  CHECK(plan.outcomes[1].status == PlanOutcome::Status::mapped);
  CHECK(plan.outcomes[2].status == PlanOutcome::Status::merged);
  CHECK(plan.outcomes[2].with == "c");
  CHECK(plan.outcomes[3].status == PlanOutcome::Status::hidden);
}

TEST_CASE("a solid outline over a drawn one says what is massive") {
  const PlanAssembly plan =
      assembled({wall("a", box(0, 0, 5, 3), true), wall("hatch", box(0, 0, 5, 3), true, PlanSides::solid)});
  CHECK(faces(plan).size() == 4);
  CHECK(has(faces(plan), {5, 0}, {0, 0}));
  CHECK(plan.outcomes[1].status == PlanOutcome::Status::merged);
  CHECK(plan.outcomes[1].with == "a");
}

TEST_CASE("what no sensor perceives stays as it was drawn") {
  PlanElement door{"d", "opal:Door", "", {{{{1, 0}, {2, 0}}}}};
  const PlanAssembly plan = assembled({wall("a", {{0, 0}, {5, 0}}), door});
  CHECK(faces(plan).size() == 3);
  CHECK(plan.map->features().back().sensor.empty());
}

TEST_CASE("curved walls of two concentric arcs have one side each") {
  PlanElement inner = wall("i", arc_points({{0, 0}, 5}, 0, 2, 0.005)),
              outer = wall("o", arc_points({{0, 0}, 5.25}, 0, 2, 0.005));
  const PlanAssembly plan = assembled({inner, outer});
  CHECK(plan.tally.two_sided_m < 0.3);
  CHECK(plan.tally.pairs_m > 20);
}

TEST_CASE("where the second face of a wall ends, the first one becomes two-sided") {
  const PlanAssembly plan = assembled({wall("a", {{0, 0}, {10, 0}}), wall("b", {{0, 0.2}, {4, 0.2}})});
  CHECK(plan.tally.pairs_m == Approx(8));
  CHECK(plan.tally.two_sided_m == Approx(6));
}

TEST_CASE("circles that were drawn as closed lines are found, octagons are not") {
  const Circle drawn{{3, -2}, 0.15};
  std::vector<Point> many = arc_points(drawn, 0.3, 2 * std::numbers::pi, 0.0005);
  many.pop_back();
  const auto circle = circle_drawn_by(many, 0.002);
  REQUIRE(circle);
  CHECK((circle->center - drawn.center).norm() < 1e-9);
  CHECK(circle->radius_m == Approx(0.15));
  std::vector<Point> octagon;
  for (int k = 0; k < 8; ++k) octagon.push_back(0.3 * unit_vector(k * std::numbers::pi / 4));
  CHECK_FALSE(circle_drawn_by(octagon, 0.002));
  CHECK_FALSE(circle_drawn_by(box(0, 0, 1, 1), 0.002));
}

TEST_CASE("coordinates that are no places are refused with the source and the element") {
  CHECK_THROWS_WITH(assembled({wall("far", {{0, 0}, {2e6, 0}})}), Catch::Contains("plan.dxf: 'far' is at (2000000"));
  CHECK_THROWS_AS(assembled({wall("nan", {{0, 0}, {std::nan(""), 0}})}), MapError);
  CHECK_THROWS_WITH(assembled({wall("w", {{0, 0}, {2, 0}}), wall("w", {{0, 1}, {2, 3}})}),
                    Catch::StartsWith("plan.dxf: "));
}
