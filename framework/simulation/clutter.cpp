#include "simulation/clutter.hpp"

#include "simulation/pieces.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <string>

namespace opal::simulation {
namespace {

void add(Piece& piece, const Piece& more) { piece.insert(piece.end(), more.begin(), more.end()); }

Pose2 turned(const Point& at, Random& random) { return {at, random.uniform(-std::numbers::pi, std::numbers::pi)}; }

// What draws twice draws one by one: arguments of one call may be evaluated in any order.

Piece cart(const std::function<Point(Random&)>& somewhere, Random& random) {
  const double width = random.uniform(0.5, 0.7), length = random.uniform(0.8, 1.2);
  return box(turned(somewhere(random), random), length, width);
}

Piece chair(const Pose2& center) { return legs(center, 0.42, 0.42, 0.015); }

Piece table(const Pose2& center, Random& random) {
  const double length = random.uniform(1.2, 1.8), width = random.uniform(0.7, 0.9);
  Piece piece = legs(center, length - 0.1, width - 0.1, 0.03);
  for (const double side : {-1, 1})
    for (const double along : {-0.3, 0.3})
      if (random.chance(0.6)) {
        const double turn_rad = random.uniform(-0.3, 0.3), gap_m = random.uniform(0.1, 0.4);
        add(piece, chair(center * Pose2(along * length, side * (width / 2 + gap_m), turn_rad)));
      }
  return piece;
}

/// Somewhere along a face, its back to the wall.
Pose2 along_face(const Segment& face, double length_m, double depth_m, Random& random) {
  const double u = random.uniform(length_m / 2, face.length_m() - length_m / 2);
  const double off = depth_m / 2 + random.uniform(0.02, 0.1);
  return {Point(face.begin + u * face.direction() + off * face.normal()), face.heading_rad()};
}

std::vector<Point> hideable(const SemanticMap& map) {
  std::vector<Point> places;
  for (const MapFeature& feature : map.features())
    if (!feature.sensor.empty() && kind_of(feature.geometry) != GeometryKind::segment)
      places.push_back(anchor_of(feature.geometry));
  return places;
}

double column_radius_m(const SemanticMap& map) {
  for (const MapFeature& feature : map.features())
    if (const auto* circle = std::get_if<Circle>(&feature.geometry)) return circle->radius_m;
  return 0.2;
}

bool is_glass(const std::string& type) {
  return type == "opal:Window" || type == "opal:Plate" || type == "opal:CurtainWall" || type == "opal:Glass";
}

/// How the leaf of a door has been moved out of its opening: turned about a hinge, or not at all.
class Leaf {
 public:
  /// @param outline  of one door; the hinge is one end of its longest straight piece.
  /// @param walls  and shut doors: an open leaf stands on the side where they leave more room, in the room, not across
  /// the corridor.
  Leaf(std::span<const Segment> outline, bool open, const RayCaster& walls, Random& random) {
    if (!open || outline.empty()) return;
    const Segment longest = *std::ranges::max_element(outline, {}, &Segment::length_m);
    const bool at_begin = random.chance(0.5), either = random.chance(0.5);
    const double left_m = room_beside_m(walls, longest, 1), right_m = room_beside_m(walls, longest, -1);
    const bool to_left = left_m == right_m ? either : left_m > right_m;
    const double angle = (to_left == at_begin ? 1 : -1) * random.uniform(std::numbers::pi / 2, 1.9);
    const Point hinge = at_begin ? longest.begin : longest.end;
    moved_ = Pose2(hinge, 0) * Pose2(0, 0, angle) * Pose2(-hinge, 0);
  }
  Segment moved(const Segment& piece) const { return transformed(moved_, piece); }

 private:
  static double room_beside_m(const RayCaster& walls, const Segment& leaf, double side) {
    constexpr double kReach_m = 10, kClear_m = 0.3;  // of the door itself
    const Point away = side * left_of(leaf.direction());
    return room_m(walls, 0.5 * (leaf.begin + leaf.end) + kClear_m * away, away, kReach_m);
  }

  Pose2 moved_;
};

/// Pieces of one object that no sensor perceives.
std::vector<Segment> unperceived(const SemanticMap& map, const MapObject& object) {
  std::vector<Segment> pieces;
  for (MapFeatureNumber number : object.features)
    if (const auto* piece = std::get_if<Segment>(&map.feature(number).geometry);
        piece && map.feature(number).sensor.empty())
      pieces.push_back(*piece);
  return pieces;
}

/// As many as there should be on average.
int count_of(double expected, Random& random) {
  return static_cast<int>(expected) + (random.chance(expected - std::floor(expected)) ? 1 : 0);
}

}  // namespace

std::vector<Solid> building_solids(const SemanticMap& map, double doors_open_share, Random& random,
                                   const std::function<bool(const MapObject&)>& stays_shut) {
  std::vector<Solid> solids;
  const RayCaster walls(shut_solids(map));
  for (const MapObject& object : map.objects()) {
    const bool is_door = object.type == "opal:Door";
    const std::vector<Segment> outline = is_door ? unperceived(map, object) : std::vector<Segment>();
    const bool may_open = is_door && random.chance(doors_open_share);
    const bool open = may_open && !(stays_shut && stays_shut(object));
    const Leaf leaf(outline, open, walls, random);
    for (const Segment& piece : outline) solids.push_back({leaf.moved(piece), false, open});
    for (MapFeatureNumber number : object.features) {
      const MapFeature& feature = map.feature(number);
      if (is_door && feature.sensor.empty()) continue;  // the leaf, done
      solids.push_back({feature.geometry, feature.sensor.empty() && is_glass(object.type)});
    }
  }
  return solids;
}

std::vector<Solid> furniture_solids(const SemanticMap& furnished, const SemanticMap& building) {
  std::set<std::string> mapped;
  for (const MapObject& object : building.objects()) mapped.insert(object.id);
  std::vector<Solid> solids;
  for (const MapObject& object : furnished.objects())
    if (!mapped.contains(object.id))
      for (MapFeatureNumber number : object.features)
        solids.push_back({furnished.feature(number).geometry, is_glass(object.type)});
  return solids;
}

std::vector<Piece> clutter_pieces(const SemanticMap& map, double floor_m2, const ClutterOptions& options,
                                  const std::function<Point(Random&)>& somewhere, Random& random) {
  std::vector<Piece> pieces;
  const auto each = [&](double per_100_m2, auto&& make) {
    for (int k = count_of(options.level * per_100_m2 * floor_m2 / 100, random); k > 0; --k) pieces.push_back(make());
  };
  each(options.tables, [&] { return table(turned(somewhere(random), random), random); });
  each(options.chairs, [&] { return chair(turned(somewhere(random), random)); });
  each(options.carts, [&] { return cart(somewhere, random); });
  each(options.bins, [&] {
    const Pose2 at = turned(somewhere(random), random);
    return random.chance(0.5) ? Piece{round_post(at.position(), random.uniform(0.15, 0.25))} : box(at, 0.4, 0.4);
  });
  each(options.lookalikes, [&] { return Piece{round_post(somewhere(random), column_radius_m(map))}; });
  constexpr double kCouch_m = 2, kCabinet_m = 3;
  if (const auto faces = long_faces(map, kCabinet_m + 0.2); !faces.empty()) {
    each(options.couches,
         [&] { return box(along_face(faces[random.below(faces.size())], kCouch_m, 0.85, random), kCouch_m, 0.85); });
    each(options.cabinets, [&] {
      return box(along_face(faces[random.below(faces.size())], kCabinet_m, 0.45, random), kCabinet_m, 0.45);
    });
  }
  for (const Point& place : hideable(map))
    if (random.chance(options.hidden_share)) {
      const double from = random.uniform(-std::numbers::pi, std::numbers::pi);
      pieces.push_back(
          box(Pose2(place + random.uniform(0.4, 0.7) * unit_vector(from), from + std::numbers::pi / 2), 1, 0.05));
    }
  return pieces;
}

}  // namespace opal::simulation
