#include "map/overlay/overlay_draft.hpp"

#include <opal/common/error.hpp>

#include <algorithm>

namespace opal {
namespace {

constexpr double kSameAngle_rad = 1e-9;

bool same_direction(double a_rad, double b_rad) { return std::abs(wrap_angle(a_rad - b_rad)) < kSameAngle_rad; }

bool same_shape(const Geometry& a, const Geometry& b) {
  if (a.index() != b.index()) return false;
  const std::vector<Point> points_a = points_of(a), points_b = points_of(b);
  for (std::size_t i = 0; i < points_a.size(); ++i)
    if ((points_a[i] - points_b[i]).norm() > kRounding_m) return false;
  if (const auto* corner = std::get_if<OrientedPoint>(&a)) {
    const auto& other = std::get<OrientedPoint>(b);
    return same_direction(corner->heading_rad, other.heading_rad) &&
           same_direction(corner->opening_rad, other.opening_rad);
  }
  if (const auto* circle = std::get_if<Circle>(&a))
    return std::abs(circle->radius_m - std::get<Circle>(b).radius_m) < kRounding_m;
  return true;
}

bool same_feature(const MapFeature& a, const MapFeature& b) {
  return a.object == b.object && a.type == b.type && a.sensor == b.sensor && a.points == b.points &&
         a.position_sigma_m == b.position_sigma_m && a.existence == b.existence && same_shape(a.geometry, b.geometry);
}

}  // namespace

OverlayDraft::OverlayDraft(const SemanticMap& map) {
  for (const MapObject& object : map.objects()) add(object);
  for (const MapFeature& feature : map.features()) add(feature);
}

MapObjectNumber OverlayDraft::add(MapObject object) {
  const MapObjectNumber number(objects.size());
  objects_by_id[object.id] = number;
  object.features.clear();  // SemanticMap fills it in
  objects.push_back(std::move(object));
  return number;
}

MapFeatureNumber OverlayDraft::add(MapFeature feature) {
  const MapFeatureNumber number(features.size());
  features_by_id[feature.id].push_back(number);
  features_by_object[feature.object].push_back(number);
  if (!feature.representation.empty()) features_by_representation[feature.representation].push_back(number);
  for (std::size_t i = 0; i < feature.points.size(); ++i)
    features_by_point[feature.points[i]].push_back({number, static_cast<int>(i)});
  features.push_back(std::move(feature));
  return number;
}

std::vector<MapFeatureNumber> OverlayDraft::settle() {
  for (const ObjectTwin& twin : object_twins)
    if (const MapObject& original = object(objects_by_id.at(twin.object.id)); twin.object.type != original.type)
      throw MapError(twin.place + ": object '" + original.id + "' is " + twin.object.type + ", but the map has it as " +
                     original.type + "; expected the same, or a MapChange");
  for (const auto& [number, twin] : feature_twins)
    if (!same_feature(feature(number), feature(twin.original)))
      throw MapError(twin.place + ": the map has another '" + feature(number).id +
                     "'; expected the same, a new id, or a MapChange of it");
  std::vector<MapFeature> kept;
  std::vector<MapFeatureNumber> numbers;
  std::set<std::pair<std::string, std::string>> known;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const bool gone = is_twin(MapFeatureNumber(i)) || !known.emplace(features[i].id, features[i].sensor).second;
    numbers.push_back(gone ? MapFeatureNumber() : MapFeatureNumber(kept.size()));
    if (!gone) kept.push_back(std::move(features[i]));
  }
  features = std::move(kept);
  return numbers;
}

}  // namespace opal
