#include "survey/tracking_graph.hpp"

#include "survey/tracking_problem.hpp"

namespace opal {
namespace {

constexpr double kBatchDoubt = 9;  // motions of neighbouring poses share errors
constexpr int kEpoch = 10;         // poses of a batch over which an offset is one number

std::size_t variables_of(const TrackedKeyframe& keyframe) { return 1 + keyframe.measurements.size(); }

}  // namespace

SolvedTrack TrackingGraph::solve(std::span<const TrackedKeyframe* const> poses, const PosePrior& oldest,
                                 const OffsetMemories& memory) const {
  if (poses.empty()) return {};
  std::size_t variables = 0;
  for (const TrackedKeyframe* keyframe : poses) variables += variables_of(*keyframe);
  TrackingProblem problem(map_, options_, poses.front()->T_map_base.position(), variables);
  for (const TrackedKeyframe* keyframe : poses) {
    problem.add_pose(*keyframe, 1);
    for (const MapMeasurement& measured : keyframe->measurements) problem.add_measurement(measured, memory, 0);
  }
  problem.add_prior(oldest);
  if (!problem.solve(false)) return {};
  SolvedTrack track = problem.solution();
  if (track.usable) problem.add_covariances(track);
  return track;
}

SolvedTrack TrackingGraph::solve_batch(std::span<const TrackedKeyframe> poses, const PosePrior& oldest,
                                       const GoesOn& goes_on) const {
  if (poses.empty()) return {};
  std::size_t variables = 0;
  for (const TrackedKeyframe& keyframe : poses) variables += variables_of(keyframe);
  TrackingProblem problem(map_, options_, poses.front().T_map_base.position(), variables);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    problem.add_pose(poses[k], kBatchDoubt);
    for (const MapMeasurement& measured : poses[k].measurements)
      problem.add_measurement(measured, {}, static_cast<int>(k) / kEpoch);
  }
  problem.add_prior(oldest);
  return problem.solve(true, goes_on) ? problem.solution() : SolvedTrack{};
}

SolvedLegs TrackingGraph::solve_together(std::span<const TrackLeg> legs, std::span<const Segment> landmarks) const {
  if (legs.empty()) return {};
  std::size_t variables = landmarks.size();
  for (const TrackLeg& leg : legs)
    for (const TrackedKeyframe& keyframe : leg.track) variables += variables_of(keyframe);
  TrackingProblem problem(map_, options_, legs.front().track.front().T_map_base.position(), variables);
  problem.add_landmarks(landmarks);
  std::vector<std::size_t> first;  // pose of each leg
  std::size_t poses = 0;
  for (const TrackLeg& leg : legs) {
    first.push_back(poses);
    poses += leg.track.size();
    problem.add_leg(leg);
  }
  const auto pose_at = [&](const LegPlace& place) { return first[place.leg] + place.keyframe; };
  for (std::size_t k = 0; k < legs.size(); ++k) {
    if (legs[k].begins_at) problem.join(pose_at(*legs[k].begins_at), first[k]);
    if (legs[k].ends_at) problem.join(pose_at(*legs[k].ends_at), first[k] + legs[k].track.size() - 1);
  }
  if (!problem.solve(true)) return {};
  const SolvedTrack all = problem.solution();
  SolvedLegs solved{all.usable, {}, all.offsets};
  problem.add_offset_sigmas(solved.offsets);
  for (std::size_t k = 0; k < legs.size(); ++k) {
    const auto from = all.T_map_base.begin() + static_cast<std::ptrdiff_t>(first[k]);
    solved.T_map_base.emplace_back(from, from + static_cast<std::ptrdiff_t>(legs[k].track.size()));
  }
  return solved;
}

}  // namespace opal
