#include "learning/landmarks.hpp"

#include "learning/face_views.hpp"

namespace opal {
namespace {

constexpr std::size_t kFewestKeyframesOfLandmark = 3;

/// All points of a face share some errors: how flat it is, how straight.
Eigen::Matrix2d covariance_of(const SeenFace& face) {
  constexpr double kFlat_m = 0.015, kStraight_rad = 0.01;
  return face.covariance + Eigen::Matrix2d(Eigen::Vector2d(kFlat_m, kStraight_rad).cwiseAbs2().asDiagonal());
}

}  // namespace

Landmarks landmarks_of(const MapView& map, const MapBelief& belief, std::span<const DriveLeg> legs,
                       std::span<const std::vector<Pose2>> T_map_base) {
  Landmarks landmarks;
  std::vector<KeyframeView> views;
  std::vector<Pose2> poses;
  std::vector<LegPlace> places;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    landmarks.sights.emplace_back(legs[k].views.size());
    for (std::size_t i = 0; i < legs[k].views.size(); ++i) {
      views.push_back({legs[k].views[i].faces, {}, {}});
      poses.push_back(T_map_base[k][i]);
      places.push_back({k, i});
    }
  }
  for (const FaceViews& face : views_of_unmapped_faces(map, belief, views, poses)) {
    if (face.keyframes.size() < kFewestKeyframesOfLandmark) continue;
    for (const FaceView& view : face.views) {
      const LegPlace& from = places[view.keyframe];
      landmarks.sights[from.leg][from.keyframe].push_back(
          {landmarks.faces.size(), view.seen->segment, covariance_of(*view.seen)});
    }
    landmarks.faces.push_back(face.longest());
  }
  return landmarks;
}

}  // namespace opal
