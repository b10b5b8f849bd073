#include <opal/import_kit/plan_assembly.hpp>

#include "import_kit/plan_faces.hpp"
#include "import_kit/plan_nodes.hpp"
#include "import_kit/plan_pairs.hpp"
#include "import_kit/plan_sides.hpp"

#include "map/check/map_check_geometry.hpp"

#include <opal/common/error.hpp>
#include <opal/import_kit/oriented_corner.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace opal {
namespace {

// Below, two faces are one that bends.
constexpr double kMinCornerSine = 0.4;
// Around a round column, beside its rim.
constexpr int kRimProbes = 16;

/// What goes into the map, object by object.
class PlanObjects {
 public:
  PlanObjects(const PlanStrokes& strokes, const std::vector<PlanElement>& elements)
      : strokes_(strokes),
        elements_(elements),
        object_(elements.size()),
        faces_(elements.size()),
        corners_(elements.size()),
        point_names_(strokes.nodes.size()) {}

  void add_face(int element, const PlanFace& face) {
    const std::string id = own_id(element, "/face-", ++faces_[static_cast<std::size_t>(element)]);
    add(element, id, "opal:Wall", Segment{strokes_.at(face.from), strokes_.at(face.to)},
        {name(face.from, id + "/begin"), name(face.to, id + "/end")});
  }

  void add_corner(int element, int node, const OrientedPoint& corner) {
    const std::string id = own_id(element, "/corner-", ++corners_[static_cast<std::size_t>(element)]);
    add(element, id, "opal:Corner", corner, {name(node, id + "/point")});
  }

  void add_circle(int element, int number) {
    const PlanElement& from = elements_[static_cast<std::size_t>(element)];
    const std::string id = from.circles.size() == 1 ? from.id + "/circle" : own_id(element, "/circle-", number + 1);
    add(element, id, "opal:Column", from.circles[static_cast<std::size_t>(number)], {});
  }

  /// An element that no sensor perceives: as it was drawn.
  void add_unseen(const PlanPath& path) {
    for (std::size_t k = 0; k + 1 < path.nodes.size() + (path.closed ? 1 : 0); ++k) {
      const int from = path.nodes[k], to = path.nodes[(k + 1) % path.nodes.size()];
      if (from == to) continue;
      const std::string id = own_id(path.element, "/line-", ++faces_[static_cast<std::size_t>(path.element)]);
      add(path.element, id, "opal:Wall", Segment{strokes_.at(from), strokes_.at(to)},
          {name(from, id + "/begin"), name(to, id + "/end")});
    }
  }

  bool has(int element) const { return object_[static_cast<std::size_t>(element)].exists(); }

  /// Takes features away. An object that has nothing else goes with them.
  /// @param repeated  ids of these features, each with the one that has the same.
  /// @return the elements that go, each with the one that has what it had.
  std::map<int, int> take_away(const std::map<std::string, std::string>& repeated) {
    std::map<std::string, MapObjectNumber> object_of;
    for (const MapFeature& feature : features_) object_of[feature.id] = feature.object;
    std::erase_if(features_, [&](const MapFeature& feature) { return repeated.contains(feature.id); });
    std::set<MapObjectNumber> objects_left;
    for (const MapFeature& feature : features_) objects_left.insert(feature.object);
    std::map<int, int> gone;
    for (const auto& [second, first] : repeated)
      if (const MapObjectNumber object = object_of.at(second); !objects_left.contains(object))
        gone[element_of(object)] = element_of(object_of.at(first));
    for (const auto& [element, other] : gone) remove_object(element);
    return gone;
  }

  std::shared_ptr<const SemanticMap> made(const std::string& source, const std::string& name,
                                          const MapOrigin& origin) const {
    try {
      return SemanticMap::make(name, objects_, features_, {}, origin);
    } catch (const MapError& error) {
      throw MapError(source + ": " + error.what());
    }
  }

 private:
  std::string own_id(int element, const char* part, int number) const {
    return elements_[static_cast<std::size_t>(element)].id + part + std::to_string(number);
  }

  int element_of(MapObjectNumber object) const {
    return static_cast<int>(std::find(object_.begin(), object_.end(), object) - object_.begin());
  }

  void remove_object(int element) {
    const MapObjectNumber removed = std::exchange(object_[static_cast<std::size_t>(element)], {});
    objects_.erase(objects_.begin() + removed.number());
    const auto move_up = [&](MapObjectNumber& it) { it = MapObjectNumber(it.number() - (it > removed)); };
    for (MapObjectNumber& object : object_) move_up(object);
    for (MapFeature& feature : features_) move_up(feature.object);
  }

  const std::string& name(int node, const std::string& proposal) {
    std::string& name = point_names_[static_cast<std::size_t>(node)];
    if (name.empty()) name = proposal;
    return name;
  }

  void add(int element, const std::string& id, const char* type, const Geometry& geometry,
           std::vector<std::string> points) {
    const PlanElement& from = elements_[static_cast<std::size_t>(element)];
    MapObjectNumber& object = object_[static_cast<std::size_t>(element)];
    if (!object.exists()) {
      object = MapObjectNumber(objects_.size());
      objects_.push_back({from.id, from.type});
    }
    features_.push_back({id, object, type, from.sensor, geometry, 0, 1, std::move(points)});
  }

  const PlanStrokes& strokes_;
  const std::vector<PlanElement>& elements_;
  std::vector<MapObjectNumber> object_;
  std::vector<int> faces_, corners_;
  std::vector<std::string> point_names_;  ///< a point is named after the first feature that it is part of
  std::vector<MapObject> objects_;
  std::vector<MapFeature> features_;
};

/// What no sensor perceives and another such thing has, too: ids of these features, each with the one that stays.
std::map<std::string, std::string> unseen_repeated(const SemanticMap& map) {
  std::map<std::string, std::string> repeated;
  for (const auto& [first, second] : duplicate_features(map))
    if (const MapFeature& feature = map.feature(second); feature.sensor.empty())
      repeated.emplace(feature.id, map.feature(first).id);
  return repeated;
}

class Assembly {
 public:
  Assembly(const std::string& source, const std::vector<PlanElement>& elements, const PlanOptions& options)
      : source_(source),
        elements_(elements),
        options_(options),
        strokes_(cut_strokes(source, elements, options.join_m)),
        centres_(options.join_m) {
    const PlanPairs pairs = find_pairs(strokes_, options);
    cut_again(strokes_, pairs.ends);
    material_ = material_of(strokes_, elements, options, pairs.walls);
    sides_ = find_sides(strokes_, material_, options);
    faces_ = join_faces(strokes_, sides_, elements, options.join_m);
  }

  PlanAssembly run(const std::string& name, const MapOrigin& origin) {
    PlanObjects objects(strokes_, elements_);
    for (std::size_t k = 0; k < elements_.size(); ++k)
      result_.outcomes.push_back({elements_[k].id, PlanOutcome::Status::empty, ""});
    tally_edges();
    add_circles(objects);
    add_faces(objects);
    add_corners(objects);
    for (const PlanPath& path : strokes_.unseen) objects.add_unseen(path);
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      for (std::size_t circle = 0; elements_[k].sensor.empty() && circle < elements_[k].circles.size(); ++circle)
        objects.add_circle(static_cast<int>(k), static_cast<int>(circle));
      if (objects.has(static_cast<int>(k))) result_.outcomes[k] = {elements_[k].id, PlanOutcome::Status::mapped, ""};
    }
    result_.map = objects.made(source_, name, origin);
    if (const auto repeated = unseen_repeated(*result_.map); !repeated.empty()) {
      for (const auto& [element, other] : objects.take_away(repeated))
        outcome(element) = {elements_[static_cast<std::size_t>(element)].id, PlanOutcome::Status::merged,
                            elements_[static_cast<std::size_t>(other)].id};
      result_.map = objects.made(source_, name, origin);
    }
    return std::move(result_);
  }

 private:
  PlanOutcome& outcome(int element) { return result_.outcomes[static_cast<std::size_t>(element)]; }
  Segment segment(const PlanFace& face) const { return {strokes_.at(face.from), strokes_.at(face.to)}; }

  void tally_edges() {
    PlanTally& tally = result_.tally;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const PlanEdge& edge = strokes_.edges[k];
      const double length_m = strokes_.length_m(edge);
      tally.repeated_m += length_m * static_cast<double>(edge.lines.size() - 1);
      if (sides_[k].is_hidden())
        hide(edge, length_m);
      else if (sides_[k].is_two_sided())
        tally.two_sided_m += length_m;
      else if (sides_[k].reasons & PlanMaterial::outline)
        tally.outlines_m += length_m;
      else
        tally.pairs_m += length_m;
    }
  }

  void hide(const PlanEdge& edge, double length_m) {
    result_.tally.hidden_m += length_m;
    for (const int line : edge.lines)
      outcome(strokes_.paths[static_cast<std::size_t>(line)].element).status = PlanOutcome::Status::hidden;
  }

  bool is_on_rim_hidden(const Circle& circle, int element) const {
    for (int k = 0; k < kRimProbes; ++k) {
      const Point p = circle.center + (circle.radius_m + kProbe_m) * unit_vector(2 * std::numbers::pi * k / kRimProbes);
      if (material_.at(p, element) == PlanMaterial::none) return false;
    }
    return true;
  }

  /// An earlier element with the same circle, or -1. What is there for the first time is remembered.
  int same_circle(const Circle& circle, int element) {
    const auto place = static_cast<std::size_t>(centres_.add(circle.center));
    if (place == circles_at_.size()) circles_at_.emplace_back();
    for (const auto& [other, radius_m] : circles_at_[place])
      if (std::abs(radius_m - circle.radius_m) <= options_.join_m) return other;
    circles_at_[place].emplace_back(element, circle.radius_m);
    return -1;
  }

  void add_circles(PlanObjects& objects) {
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      const int element = static_cast<int>(k);
      if (elements_[k].sensor.empty()) continue;
      for (std::size_t number = 0; number < elements_[k].circles.size(); ++number) {
        const Circle& circle = elements_[k].circles[number];
        const int other = same_circle(circle, element);
        if (other == element) continue;
        if (other >= 0) {
          outcome(element) = {elements_[k].id, PlanOutcome::Status::merged,
                              elements_[static_cast<std::size_t>(other)].id};
        } else if (is_on_rim_hidden(circle, element)) {
          outcome(element).status = PlanOutcome::Status::hidden;
        } else {
          objects.add_circle(element, static_cast<int>(number));
        }
      }
    }
  }

  void add_faces(PlanObjects& objects) {
    for (const PlanFace& face : faces_) {
      const double length_m = segment(face).length_m();
      if (length_m < options_.min_face_m) {
        ++result_.tally.short_faces;
        result_.tally.short_m += length_m;
        continue;
      }
      objects.add_face(face.element, face);
      for (const int other : face.others)
        outcome(other) = {elements_[static_cast<std::size_t>(other)].id, PlanOutcome::Status::merged,
                          elements_[static_cast<std::size_t>(face.element)].id};
    }
  }

  void add_corners(PlanObjects& objects) {
    const double arm_m = std::max(options_.min_corner_arm_m, options_.min_face_m);
    for (const PlanFace& before : faces_) {
      if (before.next < 0) continue;
      const PlanFace& after = faces_[static_cast<std::size_t>(before.next)];
      const Segment a = segment(before), b = segment(after);
      if (std::min(a.length_m(), b.length_m()) < arm_m ||
          std::abs(cross(a.direction(), b.direction())) < kMinCornerSine)
        continue;
      objects.add_corner(std::min(before.element, after.element), after.from, oriented_corner(a, b));
      ++result_.tally.corners;
    }
  }

  const std::string& source_;
  const std::vector<PlanElement>& elements_;
  PlanOptions options_;
  PlanStrokes strokes_;
  PlanMaterial material_;
  std::vector<EdgeSides> sides_;
  std::vector<PlanFace> faces_;
  PlanNodes centres_;
  std::vector<std::vector<std::pair<int, double>>> circles_at_;  ///< element and radius, by number of the centre
  PlanAssembly result_;
};

}  // namespace

PlanAssembly assemble_plan(const std::string& source, const std::string& name, const std::vector<PlanElement>& elements,
                           const PlanOptions& options, const MapOrigin& origin) {
  return Assembly(source, elements, options).run(name, origin);
}

}  // namespace opal
