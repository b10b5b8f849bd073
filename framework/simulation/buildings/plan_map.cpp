#include "simulation/buildings/plan_map.hpp"

#include "simulation/buildings/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

namespace opal::simulation {
namespace {

constexpr const char* kSensor = "PlanarLidar2D";
// A piece of solid that is convex all around, no longer all around than this, and no sheet, is a pillar.
constexpr int kMaxPillarPerimeter_cm = 600;
constexpr int kMinPillarSide_cm = 25;

std::string numbered(const std::string& what, int number) { return fmt::format("{}-{:04}", what, number); }

/// "opal:Rack" gives "rack".
std::string stem_of(const std::string& type) {
  std::string stem = type.substr(type.find(':') + 1);
  stem[0] = static_cast<char>(stem[0] - 'A' + 'a');
  return stem;
}

class Assembly {
 public:
  explicit Assembly(const FloorPlan& plan) : plan_(plan), things_(plan.things().size()) {}

  std::shared_ptr<const SemanticMap> run(const std::string& name) {
    for (const FloorPlan::Column& column : plan_.columns()) add(column);
    for (const Outline& outline : outlines_of(PlanGrid(plan_))) add(outline);
    for (const FloorPlan::Closure& closure : plan_.closures()) add(closure);
    return SemanticMap::make(name, std::move(objects_), std::move(features_));
  }

 private:
  using Place = std::array<int, 2>;
  static Point to_map(const Place& p) { return {p[0] / 100.0, p[1] / 100.0}; }
  static Segment segment(const OutlineFace& face) { return {to_map(face.begin), to_map(face.end)}; }
  static bool turns_left(const OutlineFace& before, const OutlineFace& after) {
    return after.quarter == (before.quarter + 1) % 4;
  }

  MapObjectNumber add_object(const std::string& type) {
    const std::string stem = stem_of(type);
    objects_.push_back({numbered(stem, ++counts_[stem]), type});
    faces_.push_back(0);
    return MapObjectNumber(objects_.size() - 1);
  }
  const std::string& id_of(MapObjectNumber object) const { return objects_[object.number()].id; }

  void add(const FloorPlan::Column& column) {
    const MapObjectNumber object = add_object("opal:Column");
    features_.push_back({id_of(object) + "/rim", object, "opal:Column", kSensor,
                         Circle{to_map({column.x, column.y}), column.radius / 100.0}});
  }

  static bool is_pillar(const Outline& outline) {
    int length = 0;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      length += outline[k].length();
      const OutlineFace& next = outline[(k + 1) % outline.size()];
      if (outline[k].thing != FloorPlan::kWall || outline[k].is_glass || turns_left(outline[k], next)) return false;
      if (outline[k].length() < kMinPillarSide_cm) return false;
    }
    return length <= kMaxPillarPerimeter_cm;
  }

  void add(const Outline& outline) {
    const MapObjectNumber pillar = is_pillar(outline) ? add_object("opal:Column") : MapObjectNumber();
    walls_.clear();
    int space = first_space(outline);
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const OutlineFace& face = outline[k];
      if (face.space != FloorPlan::kNoSpace) space = face.space;
      const MapObjectNumber object = pillar.exists() ? pillar : owner_of(face, space);
      add_face(face, object);
      add_corner(face, outline[(k + 1) % outline.size()], object);
    }
  }

  /// Jambs and niches go with what is before them.
  static int first_space(const Outline& outline) {
    for (auto face = outline.rbegin(); face != outline.rend(); ++face)
      if (face->space != FloorPlan::kNoSpace) return face->space;
    return FloorPlan::kNoSpace;
  }

  MapObjectNumber owner_of(const OutlineFace& face, int space) {
    if (face.is_glass) return add_object("opal:Window");
    MapObjectNumber& object = face.thing == FloorPlan::kWall ? walls_.try_emplace(space).first->second
                                                             : things_[static_cast<std::size_t>(face.thing)];
    if (!object.exists()) object = add_object(plan_.things()[static_cast<std::size_t>(face.thing)]);
    return object;
  }

  void add_face(const OutlineFace& face, MapObjectNumber object) {
    const std::string id = id_of(object) + "/face-" + std::to_string(++faces_[object.number()]);
    features_.push_back({id,
                         object,
                         "opal:Wall",
                         face.is_glass ? "" : kSensor,
                         segment(face),
                         0,
                         1,
                         {point_at(face.begin), point_at(face.end)}});
  }

  void add_corner(const OutlineFace& before, const OutlineFace& after, MapObjectNumber object) {
    if (before.quarter == after.quarter || before.is_glass || after.is_glass) return;
    const bool is_concave = turns_left(before, after);
    // The opening is what lies counter-clockwise from the way on, up to the way back; in eighths of a turn.
    const int opening = is_concave ? 2 : 6;
    const int heading = (2 * after.quarter + opening / 2 + 4) % 8 - 4;
    const double eighth_rad = std::numbers::pi / 4;
    features_.push_back({numbered("corner", ++counts_["corner"]),
                         object,
                         "opal:Corner",
                         kSensor,
                         OrientedPoint{to_map(after.begin), heading * eighth_rad, opening * eighth_rad},
                         0,
                         1,
                         {point_at(after.begin)}});
  }

  void add(const FloorPlan::Closure& closure) {
    const MapObjectNumber object = add_object(closure.type);
    const Box& box = closure.box;
    // Clockwise: seen from outside.
    const std::array<Place, 4> places{
        {{box.left, box.bottom}, {box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}}};
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Place &begin = places[k], &end = places[(k + 1) % places.size()];
      features_.push_back({id_of(object) + "/leaf-" + std::to_string(k + 1),
                           object,
                           "opal:Wall",
                           "",
                           Segment{to_map(begin), to_map(end)},
                           0,
                           1,
                           {point_at(begin), point_at(end)}});
    }
  }

  const std::string& point_at(const Place& place) {
    std::string& name = points_[place];
    if (name.empty()) name = numbered("point", static_cast<int>(points_.size()));
    return name;
  }

  const FloorPlan& plan_;
  std::vector<MapObject> objects_;
  std::vector<MapFeature> features_;
  std::vector<MapObjectNumber> things_;   // of the plan's things; none: not yet
  std::map<int, MapObjectNumber> walls_;  // of this outline, by room
  std::vector<int> faces_;                // how many each object has
  std::map<std::string, int> counts_;     // of names
  std::map<Place, std::string> points_;
};

}  // namespace

std::shared_ptr<const SemanticMap> map_of(const std::string& name, const FloorPlan& plan) {
  return Assembly(plan).run(name);
}

}  // namespace opal::simulation
