// What becomes of the patterns that a map names.
#include "map/overlay/overlay_draft.hpp"

#include <algorithm>

namespace opal {
namespace {

bool same_geometry(const MapFeature& a, const MapFeature& b) {
  const std::vector<Point> points_a = points_of(a.geometry), points_b = points_of(b.geometry);
  if (points_a != points_b) return false;
  if (const auto* corner = std::get_if<OrientedPoint>(&a.geometry)) {
    const auto& other = std::get<OrientedPoint>(b.geometry);
    return corner->heading_rad == other.heading_rad && corner->opening_rad == other.opening_rad;
  }
  const auto* circle = std::get_if<Circle>(&a.geometry);
  return !circle || circle->radius_m == std::get<Circle>(b.geometry).radius_m;
}

class PatternAdapter {
 public:
  PatternAdapter(const SemanticMap& map, const std::vector<MapFeature>& features,
                 const std::vector<MapFeatureNumber>& numbers)
      : map_(map), features_(features), numbers_(numbers) {}

  std::vector<MapPattern> adapted(std::vector<std::string>& sentences) {
    find_broken(sentences);
    std::vector<MapPattern> kept;
    for (MapPattern pattern : map_.patterns()) {
      if (broken_.contains(pattern.id)) continue;
      if (!pattern.dimensions.empty() &&
          std::ranges::any_of(pattern.features, [&](MapFeatureNumber i) { return is_moved(i); })) {
        pattern.dimensions.clear();
        sentences.push_back(pattern.id + ": pattern without the dimensions that it had, as a member was moved");
      }
      for (MapFeatureNumber& feature : pattern.features) feature = now(feature);
      kept.push_back(std::move(pattern));
    }
    return kept;
  }

 private:
  MapFeatureNumber now(MapFeatureNumber before) const { return numbers_[before.number()]; }
  const MapFeature& feature_now(MapFeatureNumber before) const { return features_[now(before).number()]; }
  bool is_lost(MapFeatureNumber i) const { return !now(i).exists() || feature_now(i).sensor != map_.feature(i).sensor; }
  bool is_moved(MapFeatureNumber i) const { return !same_geometry(map_.feature(i), feature_now(i)); }

  /// Patterns that have lost a member, and those that they are a part of.
  void find_broken(std::vector<std::string>& sentences) {
    std::map<std::string, std::vector<std::string>> wholes;
    std::vector<std::string> waiting;
    const auto leave_out = [&](const std::string& id, const std::string& why) {
      if (!broken_.insert(id).second) return;
      sentences.push_back(id + ": pattern left out, as " + why);
      waiting.push_back(id);
    };
    for (const MapPattern& pattern : map_.patterns()) {
      for (const std::string& part : pattern.subpatterns) wholes[part].push_back(pattern.id);
      const auto lost = std::ranges::find_if(pattern.features, [&](MapFeatureNumber i) { return is_lost(i); });
      if (lost != pattern.features.end())
        leave_out(pattern.id, "its member '" + map_.feature(*lost).id + "' is no longer perceivable");
    }
    while (!waiting.empty()) {
      const std::string part = waiting.back();
      waiting.pop_back();
      for (const std::string& whole : wholes[part]) leave_out(whole, "its part '" + part + "' is");
    }
  }

  const SemanticMap& map_;
  const std::vector<MapFeature>& features_;
  const std::vector<MapFeatureNumber>& numbers_;
  std::set<std::string> broken_;
};

}  // namespace

std::vector<MapPattern> adapted_patterns(const SemanticMap& map, const std::vector<MapFeature>& features,
                                         const std::vector<MapFeatureNumber>& numbers,
                                         std::vector<std::string>& sentences) {
  return PatternAdapter(map, features, numbers).adapted(sentences);
}

}  // namespace opal
