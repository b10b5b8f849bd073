#include "map_tools/test_maps/plan_strokes.hpp"

#include <opal/map/perceivable_faces.hpp>
#include "map_tools/building_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace opal {
namespace {

using Strokes = std::vector<Stroke>;

constexpr double kThickest_m = 0.6;  ///< of walls

/// How thick the wall is behind the middle of a face, if `other` is its other face.
std::optional<double> thickness_between(const Segment& face, const Segment& other) {
  constexpr double kParallel = 0.98;
  if (face.normal().dot(other.normal()) > -kParallel) return std::nullopt;
  const Point from = face.midpoint() - other.begin;
  const double along_m = from.dot(other.direction()),
               thick_m = -(other.midpoint() - face.midpoint()).dot(face.normal());
  if (along_m < 0 || along_m > other.length_m() || thick_m <= 0 || thick_m > kThickest_m) return std::nullopt;
  return thick_m;
}

/// 0: the wall has no other face.
double thickness_behind(const Segment& face, const std::vector<Segment>& faces) {
  double thinnest_m = kThickest_m + 1;
  for (const Segment& other : faces)
    thinnest_m = std::min(thinnest_m, thickness_between(face, other).value_or(thinnest_m));
  return thinnest_m > kThickest_m ? 0 : thinnest_m;
}

void add_closed(Strokes& strokes, const std::vector<Point>& corners) {
  for (std::size_t k = 0; k < corners.size(); ++k) strokes.push_back({corners[k], corners[(k + 1) % corners.size()]});
}

std::vector<Point> round(const Point& center, double radius_m) {
  constexpr int kCorners = 16;
  std::vector<Point> corners;
  for (int k = 0; k < kCorners; ++k)
    corners.push_back(center + radius_m * unit_vector(2 * std::numbers::pi * k / kCorners));
  return corners;
}

/// The leaf turned out of its opening, and a quarter of a circle.
void add_leaf(Strokes& strokes, const Segment& opening, Random& random) {
  constexpr int kPieces = 6;
  const bool at_end = random.chance(0.5), to_left = random.chance(0.5);
  const Point hinge = at_end ? opening.end : opening.begin, latch = at_end ? opening.begin : opening.end;
  const double side = to_left == at_end ? -1 : 1;
  const auto swung = [&](double share) {
    return Point(hinge + Pose2(0, 0, side * share * std::numbers::pi / 2).rotate(latch - hinge));
  };
  strokes.push_back({hinge, swung(1)});
  for (int k = 0; k < kPieces; ++k)
    strokes.push_back({swung(static_cast<double>(k) / kPieces), swung((k + 1.0) / kPieces)});
}

std::vector<Segment> mapped_leaves(const SemanticMap& map) {
  std::vector<Segment> leaves;
  for (const MapObject& object : map.objects())
    if (object.type == "opal:Door")
      if (const auto leaf = leaf_of(map, object); leaf && leaf->length_m() > 0) leaves.push_back(*leaf);
  return leaves;
}

/// From the end of one face to the begin of the next one along the same line.
std::vector<Segment> gaps_like_doors(const std::vector<Segment>& faces) {
  constexpr double kParallel = 0.99, kOff_m = 0.15, kNarrowest_m = 0.7, kWidest_m = 1.3;
  std::vector<Segment> gaps;
  for (const Segment& before : faces)
    for (const Segment& after : faces) {
      const Point way = after.begin - before.end;
      const double width_m = way.dot(before.direction());
      if (before.direction().dot(after.direction()) < kParallel || std::abs(way.dot(before.normal())) > kOff_m)
        continue;
      if (width_m > kNarrowest_m && width_m < kWidest_m) gaps.push_back({before.end, after.begin});
    }
  return gaps;
}

/// The bars of a display of seven bars: from, to, in a box of 1 by 2.
constexpr std::array<std::array<double, 4>, 7> kBars{
    {{0, 0, 1, 0}, {0, 1, 1, 1}, {0, 2, 1, 2}, {0, 0, 0, 1}, {0, 1, 0, 2}, {1, 0, 1, 1}, {1, 1, 1, 2}}};

}  // namespace

std::vector<Stroke> wall_strokes(const SemanticMap& map, bool single_lines) {
  const std::vector<Segment> faces = perceivable_faces(map);
  Strokes strokes;
  for (const Segment& face : faces) {
    const Point behind =
        single_lines ? Point(-0.5 * thickness_behind(face, faces) * face.normal()) : Point(Point::Zero());
    strokes.push_back({face.begin + behind, face.end + behind});
  }
  return strokes;
}

std::vector<Stroke> column_strokes(const SemanticMap& map) {
  Strokes strokes;
  for (const MapFeature& feature : map.features())
    if (const auto* column = std::get_if<Circle>(&feature.geometry); column && !feature.sensor.empty())
      add_closed(strokes, round(column->center, column->radius_m));
  return strokes;
}

std::vector<Stroke> door_strokes(const SemanticMap& map, Random& random) {
  std::vector<Segment> openings = mapped_leaves(map);
  if (openings.empty()) openings = gaps_like_doors(perceivable_faces(map));
  Strokes strokes;
  for (const Segment& opening : openings) add_leaf(strokes, opening, random);
  return strokes;
}

std::vector<Stroke> furniture_strokes(const std::vector<Point>& places, Random& random) {
  Strokes strokes;
  for (const Point& place : places) {
    if (random.chance(0.3)) {
      add_closed(strokes, round(place, random.uniform(0.25, 0.6)));
      continue;
    }
    const double length_m = random.uniform(0.5, 1.8), width_m = random.uniform(0.4, 0.9);
    const Pose2 T_map_thing(place, random.chance(0.5) ? 0 : std::numbers::pi / 2);
    add_closed(strokes, {T_map_thing * Point(0, 0), T_map_thing * Point(length_m, 0),
                         T_map_thing * Point(length_m, width_m), T_map_thing * Point(0, width_m)});
  }
  return strokes;
}

std::vector<Stroke> word_strokes(const std::vector<Point>& places, Random& random) {
  Strokes strokes;
  for (const Point& place : places) {
    const double letter_m = random.uniform(0.12, 0.25);  // half its height
    const int letters = 3 + static_cast<int>(random.below(4));
    for (int k = 0; k < letters; ++k)
      for (const auto& [x, y, to_x, to_y] : kBars)
        if (random.chance(0.6)) {
          const Point corner = place + letter_m * Point(1.6 * k, 0);
          strokes.push_back({corner + letter_m * Point(x, y), corner + letter_m * Point(to_x, to_y)});
        }
  }
  return strokes;
}

}  // namespace opal
