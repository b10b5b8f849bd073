// Corners turn with the faces that meet in them.
#include "map/overlay/overlay_draft.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace opal {
namespace {

constexpr double kFits_rad = 0.02;  // a corner that differs more from its faces was not made of them
constexpr double kTurned_rad = 1e-9;

/// The faces that end and begin at a point, seen from their left.
struct Faces {
  std::optional<MapFeatureNumber> before, after;
  bool several = false;
};

void take(std::optional<MapFeatureNumber>& face, MapFeatureNumber feature, const OverlayDraft& draft, bool& several) {
  if (face && draft.feature(*face).id != draft.feature(feature).id) several = true;
  if (!face) face = feature;
}

Faces faces_at(const OverlayDraft& draft, const std::string& point) {
  Faces faces;
  for (const OverlayDraft::Place& place : draft.features_by_point.at(point)) {
    if (draft.is_twin(place.feature) || kind_of(draft.feature(place.feature).geometry) != GeometryKind::segment)
      continue;
    take(place.point == 0 ? faces.after : faces.before, place.feature, draft, faces.several);
  }
  return faces;
}

/// Heading and opening of the corner that two faces make.
OrientedPoint corner_of(const Segment& before, const Segment& after) {
  const double two_pi = 2 * std::numbers::pi, from = after.heading_rad();
  const double opening = std::fmod(before.heading_rad() + std::numbers::pi - from + 2 * two_pi, two_pi);
  return {after.begin, wrap_angle(from + opening / 2), opening};
}

double angle_between(double a_rad, double b_rad) { return std::abs(wrap_angle(a_rad - b_rad)); }

bool fits(const OrientedPoint& corner, const OrientedPoint& faces, double tolerance_rad) {
  return angle_between(corner.heading_rad, faces.heading_rad) < tolerance_rad &&
         std::abs(corner.opening_rad - faces.opening_rad) < tolerance_rad;
}

/// Who takes a wall away may have forgotten its corner.
void doubt_lonely(const std::vector<MapFeature>& before, const OverlayDraft& draft, MapFeatureNumber corner,
                  const Faces& faces, std::vector<std::string>& doubts) {
  const std::string& sensor = draft.feature(corner).sensor;
  if (sensor.empty() || draft.is_twin(corner)) return;
  for (const MapFeatureNumber face : {*faces.before, *faces.after})
    if (before[face.number()].sensor == sensor && draft.feature(face).sensor != sensor) {
      doubts.push_back(draft.feature(corner).id + ": is still perceivable by " + sensor + ", but '" +
                       draft.feature(face).id + "', which meets in it, no longer is");
      return;
    }
}

}  // namespace

void turn_corners(const std::vector<MapFeature>& before, const std::set<std::string>& set_corners, OverlayDraft& draft,
                  std::vector<std::string>& sentences, std::vector<std::string>& doubts) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    const MapFeatureNumber number(i);
    MapFeature& feature = draft.feature(number);
    auto* corner = std::get_if<OrientedPoint>(&feature.geometry);
    if (!corner || set_corners.contains(feature.id)) continue;
    const Faces faces = faces_at(draft, feature.points.front());
    if (!faces.before || !faces.after) continue;
    const MapFeatureNumber limit(before.size());
    if (*faces.before >= limit || *faces.after >= limit) continue;  // a face was added
    doubt_lonely(before, draft, number, faces, doubts);
    const auto segment = [](const MapFeature& face) { return std::get<Segment>(face.geometry); };
    const OrientedPoint was =
        corner_of(segment(before[faces.before->number()]), segment(before[faces.after->number()]));
    const OrientedPoint is = corner_of(segment(draft.feature(*faces.before)), segment(draft.feature(*faces.after)));
    if (fits(was, is, kTurned_rad)) continue;
    const auto& old_corner = std::get<OrientedPoint>(before[i].geometry);
    if (faces.several || !fits(old_corner, was, kFits_rad)) {
      if (!draft.is_twin(number))
        doubts.push_back(feature.id +
                         ": faces that meet in it have turned, but not its heading_rad and opening_rad; expected a "
                         "change that says them");
      continue;
    }
    corner->heading_rad = is.heading_rad;
    corner->opening_rad = is.opening_rad;
    if (!draft.is_twin(number)) sentences.push_back(feature.id + ": turned with the faces that meet in it");
  }
}

}  // namespace opal
