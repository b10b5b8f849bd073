#include "map_assembly.hpp"

#include <opal/import_kit/oriented_corner.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

namespace opal::ifc_importer {
namespace {

// What is just as long as one of these limits is long enough, wherever the building stands: many parts measure 10 cm.
constexpr double kRounding_m = 1e-5;
// Shorter faces are rounding and chamfers: no detector finds them.
constexpr double kShortestFace_m = 0.02 - kRounding_m;
// Posts and balusters thinner than this around give a few returns, and no face.
constexpr double kThinnestAround_m = 0.35 - kRounding_m;
// A corner is seen by its two arms.
constexpr double kShortestArm_m = 0.1 - kRounding_m;
constexpr double kLeastTurn_rad = 0.17;  // 10 degrees: facets of curved walls are no corners
constexpr double kFolded_rad = 3.04;     // the edge of a sheet, of 6 degrees, is none either
constexpr double kStraight_rad = 0.02;
// Of a round column in a wall, that much must be visible to be one.
constexpr double kLeastCircle = 0.5;

class Assembly {
 public:
  Assembly(const std::vector<ElementCut>& cuts, const Plan& plan, const std::vector<std::size_t>& order,
           const Duplicates& duplicates, const std::string& sensor)
      : cuts_(cuts), plan_(plan), order_(order), sensor_(sensor) {
    for (const ElementCut& cut : cuts) add_object(cut, duplicates);
  }

  AssembledMap run(const std::string& name, const MapOrigin& origin) {
    std::vector<bool> is_visible(order_.size());
    for (const std::vector<PlanFace>& chain : plan_.chains) add(chain, is_visible);
    for (const PlanCircle& circle : plan_.circles) add(circle, is_visible);
    for (std::size_t k = 0; k < order_.size(); ++k)
      if (!is_visible[k]) result_.hidden.push_back(cut_of(static_cast<int>(k)).element->id);
    for (const ElementCut& cut : cuts_) add_unseen(cut);
    result_.map = SemanticMap::make(name, std::move(objects_), std::move(features_), {}, origin);
    return std::move(result_);
  }

 private:
  const ElementCut& cut_of(int owner) const { return cuts_[order_[static_cast<std::size_t>(owner)]]; }
  MapObjectNumber object_of(const ElementCut& cut) const { return numbers_.at(cut.object->id); }

  void add_object(const ElementCut& cut, const Duplicates& duplicates) {
    const Element& source = *cut.object;
    const auto [entry, is_new] = numbers_.try_emplace(source.id, objects_.size());
    if (is_new) {
      MapObject object{source.id, cut.treatment.type};
      object.notes.name = source.name;
      object.notes.source_class = source.source_class();
      object.notes.storey = source.storey;
      object.notes.thickness_m = source.thickness_m.value_or(0);
      object.notes.axis = source.axis;
      if (const auto others = duplicates.ids.find(source.id); others != duplicates.ids.end())
        object.notes.merged_ids = others->second;
      objects_.push_back(std::move(object));
    }
    if (cut.width_m > 0) objects_[entry->second.number()].notes.width_m = cut.width_m;
  }

  std::string numbered(MapObjectNumber object, const char* what) {
    const std::string prefix = objects_[object.number()].id + "/" + what;
    return fmt::format("{}-{}", prefix, ++counts_[prefix]);
  }

  Segment segment(const PlanFace& face) const {
    return {plan_.nodes[static_cast<std::size_t>(face.begin)], plan_.nodes[static_cast<std::size_t>(face.end)]};
  }

  /// A point is named after the first thing that has it.
  std::string point_name(int node, MapObjectNumber object) {
    std::string& name = points_[node];
    if (name.empty()) name = numbered(object, "point");
    return name;
  }

  double length_of(const std::vector<PlanFace>& chain) const {
    double length_m = 0;
    for (const PlanFace& face : chain) length_m += segment(face).length_m();
    return length_m;
  }

  void add(const std::vector<PlanFace>& chain, std::vector<bool>& is_visible) {
    for (const PlanFace& face : chain) is_visible[static_cast<std::size_t>(face.owner)] = true;
    if (length_of(chain) < kThinnestAround_m) {
      ++result_.posts;
      return;
    }
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const PlanFace& face = chain[k];
      if (face.is_round) continue;
      const double length_m = segment(face).length_m();
      if (length_m < kShortestFace_m) {
        ++result_.specks;
        continue;
      }
      const MapObjectNumber object = object_of(cut_of(face.owner));
      ++result_.faces;
      result_.length_m += length_m;
      features_.push_back({numbered(object, "face"),
                           object,
                           "opal:Wall",
                           sensor_,
                           segment(face),
                           0,
                           1,
                           {point_name(face.begin, object), point_name(face.end, object)}});
      add_corner(chain, k);
    }
  }

  /// How far a chain goes straight on from a corner, whoever owns the faces: a frame lies in line with its wall.
  double arm_m(const std::vector<PlanFace>& chain, std::size_t from, bool forward) const {
    const std::size_t n = chain.size();
    const double heading_rad = segment(chain[from]).heading_rad();
    double length_m = 0;
    for (std::size_t step = 0; step < n; ++step) {
      const PlanFace& face = chain[(from + (forward ? step : n - step)) % n];
      if (face.is_round || std::abs(wrap_angle(segment(face).heading_rad() - heading_rad)) > kStraight_rad) break;
      length_m += segment(face).length_m();
    }
    return length_m;
  }

  /// Between a face and the next one.
  void add_corner(const std::vector<PlanFace>& chain, std::size_t k) {
    const std::size_t next = (k + 1) % chain.size();
    const Segment a = segment(chain[k]), b = segment(chain[next]);
    const double turn_rad = std::abs(wrap_angle(b.heading_rad() - a.heading_rad()));
    if (chain[next].is_round || b.length_m() < kShortestFace_m || turn_rad < kLeastTurn_rad || turn_rad > kFolded_rad)
      return;
    if (std::min(arm_m(chain, k, false), arm_m(chain, next, true)) < kShortestArm_m) return;
    const MapObjectNumber object = object_of(cut_of(chain[k].owner));
    ++result_.corners;
    features_.push_back({numbered(object, "corner"),
                         object,
                         "opal:Corner",
                         sensor_,
                         oriented_corner(a, b),
                         0,
                         1,
                         {point_name(chain[k].end, object)}});
  }

  void add(const PlanCircle& circle, std::vector<bool>& is_visible) {
    const ElementCut& cut = cut_of(circle.owner);
    if (circle.visible_share <= 0 || 2 * std::numbers::pi * circle.circle.radius_m < kThinnestAround_m) return;
    is_visible[static_cast<std::size_t>(circle.owner)] = true;
    if (circle.visible_share < kLeastCircle) return result_.hidden_rounds.push_back(cut.element->id);
    const MapObjectNumber object = object_of(cut);
    ++result_.circles;
    features_.push_back({numbered(object, "rim"), object, "opal:Column", sensor_, circle.circle});
  }

  /// Leaves, panes and glass stay in the map; no sensor is named that perceives them.
  void add_unseen(const ElementCut& cut) {
    const MapObjectNumber object = object_of(cut);
    for (const Loop& loop : cut.unseen)
      for (const Segment& s : segments_of({loop}))
        if (s.length_m() >= kShortestFace_m)
          features_.push_back({numbered(object, "unseen"), object, "opal:Wall", "", Segment{s.end, s.begin}});
  }

  const std::vector<ElementCut>& cuts_;
  const Plan& plan_;
  const std::vector<std::size_t>& order_;
  const std::string& sensor_;
  std::map<std::string, MapObjectNumber> numbers_;  // by id
  std::map<std::string, int> counts_;
  std::map<int, std::string> points_;  // names of nodes
  std::vector<MapObject> objects_;
  std::vector<MapFeature> features_;
  AssembledMap result_;
};

}  // namespace

AssembledMap assemble(const std::string& name, const std::vector<ElementCut>& cuts, const Plan& plan,
                      const std::vector<std::size_t>& order, const Duplicates& duplicates, const MapOrigin& origin,
                      const std::string& sensor) {
  return Assembly(cuts, plan, order, duplicates, sensor).run(name, origin);
}

}  // namespace opal::ifc_importer
