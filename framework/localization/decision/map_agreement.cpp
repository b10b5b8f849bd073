#include "localization/decision/map_agreement.hpp"

#include "common/pose_tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

constexpr std::size_t kReturns = 60;  // per scan; more tell hardly more
// A fall is this large at least, and so many times the usual change. Where fewer beams than this share of all tell, as
// behind a door on a map of long walls, it says nothing. docs/notebook/evidence.md, 2026-11-28.
constexpr double kLeastFall = 0.2, kTimesUsual = 6, kFewestBeams = 0.5;
constexpr double kChangeMemory = 0.95;  // of some twenty scans
constexpr double kOnSurface_m = 0.2, kPassed_m = 0.2, kPassedPer_m = 0.012;

/// Of one return.
MapAgreement agreement(const MapView& map, const Point& eye, const Point& end) {
  const double range_m = (end - eye).norm();
  if (map.first_crossing(eye, end, kPassed_m + kPassedPer_m * range_m).feature.exists()) return {0, 1};
  const MapFeatureNumber nearest = map.nearest_facing(end, end - eye);
  return {nearest.exists() && map.surface(nearest).distance_m(end) < kOnSurface_m ? 1.0 : 0.0, 0};
}

}  // namespace

MapAgreement agreement(const Observation& observation, const MapView& map, const Pose2& T_map_base) {
  MapAgreement all;
  const std::size_t points = observation.points(), step = std::max<std::size_t>(1, (points + kReturns - 1) / kReturns);
  double looked = 0;
  for (const ObservedScan& scan : observation.scans) {
    const Point eye = T_map_base * scan.laser_position;
    for (std::size_t k = 0; k < scan.points.size(); k += step, ++looked) {
      const MapAgreement one = agreement(map, eye, T_map_base * scan.points[k]);
      all.met += one.met;
      all.passed += one.passed;
    }
  }
  return looked > 0 ? MapAgreement{all.met / looked, all.passed / looked} : MapAgreement{};
}

const MapAgreement& ScanAgreement::at(const Pose2& T_map_base, const Observation& observation, const MapView& map) {
  if (!seen_ || !is_same_pose(seen_->T_map_base, T_map_base))
    seen_ = {T_map_base, agreement(observation, map, T_map_base)};
  return seen_->agreement;
}

void MeanAgreement::add(const MapAgreement& scan, double tempering_weight) {
  const double kept = std::pow(memory_, tempering_weight);
  sum_ = {kept * sum_.met + (1 - kept) * scan.met, kept * sum_.passed + (1 - kept) * scan.passed};
}

bool AgreementFall::add(const MapAgreement& scan) {
  const double fall = share_ - scan.share();
  const bool fell = scan.met + scan.passed > kFewestBeams && fall > std::max(kLeastFall, kTimesUsual * usual_change_);
  usual_change_ = kChangeMemory * usual_change_ + (1 - kChangeMemory) * std::abs(fall);
  share_ = scan.share();
  return fell;
}

}  // namespace opal
