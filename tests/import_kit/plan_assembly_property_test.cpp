#include <opal/import_kit/plan_assembly.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace opal;

namespace {

/// Walls, thin and drawn as outlines or pairs of lines, at any place and angle, and round columns.
std::vector<PlanElement> random_plan(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 20), length(0.5, 8), thickness(0.08, 0.4);
  std::vector<PlanElement> elements;
  for (int k = 0; k < 14; ++k) {
    const Pose2 T{place(random), place(random), k % 3 == 0 ? place(random) : 0.5 * std::numbers::pi * (k % 2)};
    const double l = length(random), t = thickness(random);
    PlanElement element{"e" + std::to_string(k), "opal:Wall"};
    if (k % 4 == 0) {
      element.circles = {{T.position(), t}};
    } else if (k % 4 == 1) {
      element.lines = {{{T * Point(0, 0), T * Point(l, 0)}}, {{T * Point(0, t), T * Point(l, t)}}};
    } else {
      element.lines = {{{T * Point(0, 0), T * Point(l, 0), T * Point(l, t), T * Point(0, t)},
                        true,
                        k % 4 == 2 ? PlanSides::solid : PlanSides::to_find}};
    }
    elements.push_back(std::move(element));
  }
  return elements;
}

std::vector<PlanElement> moved(const Pose2& T, std::vector<PlanElement> elements) {
  for (PlanElement& element : elements) {
    for (PlanLine& line : element.lines)
      for (Point& p : line.points) p = T * p;
    for (Circle& circle : element.circles) circle.center = T * circle.center;
  }
  return elements;
}

PlanAssembly assembled_plan(const std::vector<PlanElement>& elements) {
  return assemble_plan("plan", "plan", elements);
}

double face_length_m(const SemanticMap& map) {
  double length_m = 0;
  for (const MapFeature& feature : map.features())
    if (const auto* segment = std::get_if<Segment>(&feature.geometry)) length_m += segment->length_m();
  return length_m;
}

}  // namespace

TEST_CASE("a plan that is moved gives the same map, moved") {
  const unsigned seed = GENERATE(range(1u, 31u));
  CAPTURE(seed);
  const Pose2 T(-37, 12.5, 0.1 * seed);
  const PlanAssembly here = assembled_plan(random_plan(seed)), there = assembled_plan(moved(T, random_plan(seed)));
  REQUIRE(here.map->features().size() == there.map->features().size());
  for (std::size_t k = 0; k < here.map->features().size(); ++k) {
    const Geometry expected = transformed(T, here.map->features()[k].geometry);
    CHECK(distance_m(expected, anchor_of(there.map->features()[k].geometry)) <
          0.02 + (std::holds_alternative<Circle>(expected) ? 1 : 0));
  }
  CHECK(face_length_m(*here.map) == Approx(face_length_m(*there.map)).margin(0.02));
}

TEST_CASE("every face of massive walls has free space before it and wall behind it") {
  const unsigned seed = GENERATE(range(1u, 31u));
  CAPTURE(seed);
  const PlanAssembly plan = assembled_plan(random_plan(seed));
  for (const MapFeature& feature : plan.map->features()) {
    const auto* face = std::get_if<Segment>(&feature.geometry);
    if (face == nullptr || face->length_m() < 0.1) continue;
    for (const MapFeature& other : plan.map->features())
      if (const auto* circle = std::get_if<Circle>(&other.geometry))
        CHECK((face->midpoint() - circle->center).norm() > circle->radius_m - 0.011);
  }
  for (const PlanOutcome& outcome : plan.outcomes)
    CHECK((outcome.status != PlanOutcome::Status::merged || !outcome.with.empty()));
}

TEST_CASE("corners are where two faces share a point, and everything that shares a place shares it") {
  const unsigned seed = GENERATE(range(1u, 31u));
  const PlanAssembly plan = assembled_plan(random_plan(seed));
  std::vector<std::pair<std::string, Point>> ends;
  for (const MapFeature& feature : plan.map->features())
    if (const auto* face = std::get_if<Segment>(&feature.geometry)) {
      ends.emplace_back(feature.points[0], face->begin);
      ends.emplace_back(feature.points[1], face->end);
    }
  for (std::size_t a = 0; a < ends.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      CHECK(((ends[a].second - ends[b].second).norm() > 0.01) == (ends[a].first != ends[b].first));
  for (const MapFeature& feature : plan.map->features())
    if (std::holds_alternative<OrientedPoint>(feature.geometry))
      CHECK(std::ranges::count_if(ends, [&](const auto& end) { return end.first == feature.points[0]; }) >= 2);
}
