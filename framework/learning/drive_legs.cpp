#include "learning/drive_legs.hpp"

#include "learning/landmarks.hpp"
#include "survey/scan_on_map.hpp"
#include "survey/seen_through.hpp"

#include <opal/common/error.hpp>
#include <opal/common/quantile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace opal {
namespace {

// What is recognized depends on the poses, and they on what is recognized. In the first round, the map alone holds legs
// together.
constexpr int kRounds = 3;
// Where a leg began is known from a map that is wrong there: all that the drive sees says it better.
const Eigen::Vector3d kStartSigma{1, 1, 0.2};

ExpectedFeatures expected_from(const MapView& map, const MapBelief& belief, const Point& eye) {
  const PoseTrackerOptions options;
  return {map, belief, eye, options.view_m, options.wall_error_m};
}

std::vector<MapMeasurement> measured_from(const MapView& map, const MapBelief& belief, const KeyframeView& view,
                                          const Pose2& T_map_base) {
  std::vector<MapMeasurement> found;
  for (const auto& [laser, points] : view.returns)
    for (MapMeasurement& each :
         measure(expected_from(map, belief, T_map_base * laser), points, laser, T_map_base, PoseTrackerOptions{}))
      found.push_back(std::move(each));
  return found;
}

MapBelief belief_of(const MapView& map, const SolvedLegs& solved) {
  MapBelief belief(map.map().features().size());
  for (const auto& [feature, offset] : solved.offsets) {
    belief[feature].moved = offset.moved;
    belief[feature].sigma_m = offset.sigma_m;
    belief[feature].observations = 1;
  }
  return belief;
}

SolvedLegs solved_once(const MapView& map, const std::vector<DriveLeg>& legs, const Landmarks& landmarks) {
  std::vector<TrackLeg> parts;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    const DriveLeg& leg = legs[k];
    parts.push_back({leg.track, kStartSigma, leg.begins_at, leg.ends_at});
    if (!landmarks.faces.empty()) parts.back().landmarks = landmarks.sights[k];
  }
  SolvedLegs solved = TrackingGraph(map, PoseTrackerOptions{}).solve_together(parts, landmarks.faces);
  if (!solved.usable)
    throw Error(fmt::format("learning: the factor graph of {} legs has no usable solution", legs.size()));
  return solved;
}

SolvedLegs solved_together(const MapView& map, std::vector<DriveLeg>& legs) {
  SolvedLegs solved = solved_once(map, legs, {});
  for (int round = 1; round < kRounds; ++round) {
    const MapBelief belief = belief_of(map, solved);
    for (std::size_t k = 0; k < legs.size(); ++k)
      for (std::size_t i = 0; i < legs[k].track.size(); ++i) {
        TrackedKeyframe& keyframe = legs[k].track[i];
        keyframe.T_map_base = solved.T_map_base[k][i];
        keyframe.measurements = measured_from(map, belief, legs[k].views[i], keyframe.T_map_base);
      }
    solved = solved_once(map, legs, landmarks_of(map, belief, legs, solved.T_map_base));
  }
  return solved;
}

/// Whether more beams end on the map along a leg than pass through it.
bool fits(const MapView& map, const MapBelief& belief, const DriveLeg& leg, std::span<const Pose2> T_map_base) {
  double fit = 0;
  for (std::size_t k = 0; k < leg.views.size(); ++k) {
    const auto& [laser, points] = leg.views[k].returns.front();
    const ExpectedFeatures expected = expected_from(map, belief, T_map_base[k] * laser);
    fit += share_on(expected, points, laser, T_map_base[k]) - share_through(expected, points, laser, T_map_base[k]);
  }
  return fit > 0;
}

/// Where one visit sees the features of the map.
class SecondLook {
 public:
  SecondLook(const MapView& map, const MapBelief& consensus) : map_(map), consensus_(consensus), counted_(consensus) {
    for (FeatureBelief& each : counted_) each.observations = 0;
  }

  void add(const KeyframeView& view, const Pose2& T_map_base) {
    for (const auto& [laser, points] : view.returns)
      count_seen(counted_, expected_from(map_, consensus_, T_map_base * laser), points, laser, T_map_base);
    for (const MapMeasurement& measured : measured_from(map_, consensus_, view, T_map_base)) {
      FeatureBelief& known = counted_[measured.feature];
      ++known.observations;
      known.covered_m = std::max(known.covered_m, covered_m(measured));
      const Point off = offset_of(measured, T_map_base);
      x_[measured.feature].push_back(off.x());
      y_[measured.feature].push_back(off.y());
    }
  }

  MapBelief belief() const {
    MapBelief belief = counted_;
    for (const auto& [feature, x] : x_) belief[feature].moved = {upper_median_of(x), upper_median_of(y_.at(feature))};
    return belief;
  }

 private:
  Point offset_of(const MapMeasurement& measured, const Pose2& T_map_base) const {
    const Geometry& mapped = map_.map().feature(measured.feature).geometry;
    if (const auto* face = std::get_if<Segment>(&mapped)) {
      const Point seen = T_map_base * std::get<Segment>(measured.seen).midpoint();
      return face->normal() * face->normal().dot(seen - face->begin);
    }
    return T_map_base * anchor_of(measured.seen) - anchor_of(mapped);
  }

  const MapView& map_;
  const MapBelief& consensus_;
  MapBelief counted_;
  std::map<MapFeatureNumber, std::vector<double>> x_, y_;
};

/// An object of several faces stands elsewhere if one of them does.
std::vector<Deviation> deviations_by_face(const SemanticMap& map, const MapBelief& belief) {
  const DeviationOptions options;
  std::vector<Deviation> found = deviations_of(map, belief, options);
  for (Deviation& deviation : found)
    for (const FaceOffset& face : deviation.faces)
      if (deviation.verdict == DeviationVerdict::as_mapped &&
          std::abs(face.offset_m) > std::max(options.least_offset_m, options.sigmas * face.sigma_m))
        deviation.verdict = DeviationVerdict::moved;
  return found;
}

}  // namespace

std::vector<VisitEvidence> evidence_of(const MapView& map, std::vector<DriveLeg> legs) {
  std::vector<VisitEvidence> said;
  if (legs.empty()) return said;
  const SolvedLegs solved = solved_together(map, legs);
  const MapBelief consensus = belief_of(map, solved);
  for (std::size_t k = 0; k < legs.size(); ++k) {
    if (legs[k].is_gap && !fits(map, consensus, legs[k], solved.T_map_base[k])) continue;
    std::size_t from = 0;
    for (const std::size_t count : legs[k].visits) {
      const auto views = std::span(legs[k].views).subspan(from, count);
      const auto poses = std::span(solved.T_map_base[k]).subspan(from, count);
      SecondLook look(map, consensus);
      for (std::size_t i = 0; i < count; ++i) look.add(views[i], poses[i]);
      const MapBelief belief = look.belief();
      said.push_back({deviations_by_face(map.map(), belief), unmapped_faces(map, belief, views, poses)});
      from += count;
    }
  }
  return said;
}

}  // namespace opal
