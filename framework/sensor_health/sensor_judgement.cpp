#include "sensor_health/sensor_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace opal {
namespace {

using Subject = SensorFinding::Subject;
using Verdict = SensorFinding::Verdict;

/// How far something may be off before it is doubtful, and before it turns answers; and how well it must be known.
struct Bounds {
  double doubtful, contradicted;
  double most_sigma;  ///< known worse than this, nothing is said
};
// A pose counts as right within 1 m and 10 degrees: a mount that is off by as much makes it wrong by itself. The scan
// matcher bears with odometry of a wrong scale (as a logarithm), up to twice or half.
constexpr Bounds kHeading_rad{0.05, 0.17, ToldWithin::heading_rad};
constexpr Bounds kPosition_m{0.1, 0.5, ToldWithin::position_m};
constexpr Bounds kScale{0.1, 0.69, ToldWithin::scale};
constexpr double kSigmas = 4;  // a difference is one from so many standard deviations on
constexpr double kMostBetter = 0.8;
constexpr int kFewestMotions = 5;
constexpr double kLeastTurned_rad = 0.8, kLeastDriven_m = 0.8;

/// A standing robot's scans lie over each other to a few centimetres; people in them do not move all of it.
constexpr double kMoves_m = 0.1, kMoves_rad = 0.08;
constexpr std::size_t kMovingMotions = 3;

constexpr int kScansOfRanges = 10;
constexpr double kFewestUsable = 0.02;
constexpr double kRepeatedScans = 0.1, kFartherScans = 0.05;

/// @param better  share of the motions that speak against the description: single ones that went wrong do not.
/// @return none if the drive is against the description, and its motions are not.
std::optional<Verdict> verdict_of(double off, double sigma, const Bounds& bounds, double better) {
  if (off < kSigmas * sigma || off <= bounds.doubtful) return Verdict::fine;
  if (better < kMostBetter) return std::nullopt;
  return off > bounds.contradicted ? Verdict::contradicted : Verdict::doubtful;
}

const char* ending_of(Verdict verdict) { return verdict == Verdict::fine ? ": fine" : ""; }

std::optional<SensorFinding> turn_finding(const MotionCalibration& drive) {
  const Estimated& scale = drive.turn_scale;
  const double by_odometry = drive.turned_rad, by_scans = scale.value * by_odometry;
  const std::string turned =
      fmt::format("scans turn by {:.2f} rad where odometry turns by {:.2f}", by_scans, by_odometry);
  const double off = scale.value < 0 ? 2 : std::abs(std::log(scale.value));
  const auto verdict = verdict_of(off, scale.sigma, kScale, drive.turns_better);
  if (!verdict) return std::nullopt;
  if (scale.value < 0)
    return SensorFinding{Subject::mirroring,
                         *verdict,
                         -1,
                         1,
                         scale.sigma,
                         turned + ": is the laser mounted upside down, or is one of the two mirrored?"};
  const char* end = *verdict == Verdict::fine ? ": fine" : ": is the odometry's heading scaled, or in other units?";
  return SensorFinding{Subject::odometry_turn, *verdict, scale.value, 1, scale.sigma, turned + end};
}

std::string guess_of_heading(double off_rad, double heading_rad) {
  const double off_deg = degrees(std::abs(off_rad)), quarters = std::round(degrees(heading_rad) / 90);
  if (off_deg > 150)
    return fmt::format(": scans move backwards when odometry moves forwards: is the laser mounted at {:.0f} degrees?",
                       quarters == -2 ? 180 : 90 * quarters + 0.0);
  if (std::abs(off_deg - 90) < 20) return ": is the laser mounted sideways, or are the axes swapped?";
  return ": is the laser's heading on the robot, or its first angle, described wrongly?";
}

std::optional<SensorFinding> heading_finding(const MotionCalibration& drive, const Pose2& T_base_laser) {
  const Estimated& heading = drive.mount_heading_rad;
  const double off_rad = wrap_angle(heading.value - T_base_laser.heading_rad());
  const auto verdict = verdict_of(std::abs(off_rad), heading.sigma, kHeading_rad, drive.distances_better);
  if (!verdict) return std::nullopt;
  std::string words = fmt::format(
      "the laser looks {:.1f} +- {:.1f} degrees to the left of the driving direction, and is described at {:.1f}",
      degrees(heading.value), degrees(heading.sigma), degrees(T_base_laser.heading_rad()));
  words += *verdict == Verdict::fine ? ending_of(*verdict) : guess_of_heading(off_rad, heading.value);
  return SensorFinding{Subject::mount_heading,     *verdict,      heading.value,
                       T_base_laser.heading_rad(), heading.sigma, words};
}

std::optional<SensorFinding> distance_finding(const MotionCalibration& drive) {
  const Estimated& scale = drive.distance_scale;
  const auto verdict = verdict_of(std::abs(std::log(scale.value)), scale.sigma, kScale, drive.distances_better);
  if (!verdict) return std::nullopt;
  std::string words = fmt::format("scans move by {:.2f} m where odometry moves by {:.2f}", scale.value * drive.driven_m,
                                  drive.driven_m);
  words += *verdict == Verdict::fine
               ? ending_of(*verdict)
               : ": is the wheel radius wrong, do wheels slip, or are ranges or odometry in other units?";
  return SensorFinding{Subject::odometry_distance, *verdict, scale.value, 1, scale.sigma, words};
}

std::optional<SensorFinding> position_finding(const MotionCalibration& drive, const Pose2& T_base_laser) {
  const double off_m = (drive.mount_position_m - T_base_laser.position()).norm(), sigma = drive.mount_position_sigma_m;
  const auto verdict = verdict_of(off_m, sigma, kPosition_m, drive.distances_better);
  if (!verdict) return std::nullopt;
  std::string words = fmt::format(
      "in turns the laser moves as if it sat at ({:.2f}, {:.2f}) m on the robot, and is described at ({:.2f}, {:.2f})",
      drive.mount_position_m.x(), drive.mount_position_m.y(), T_base_laser.x(), T_base_laser.y());
  return SensorFinding{Subject::mount_position, *verdict, off_m, 0, sigma, words + ending_of(*verdict)};
}

}  // namespace

std::vector<SensorFinding> judge_motion(const MotionCalibration& drive, const Pose2& T_base_laser) {
  std::vector<SensorFinding> findings;
  if (drive.pairs < kFewestMotions) return findings;
  const auto tell = [&](std::optional<SensorFinding> finding) {
    if (finding) findings.push_back(std::move(*finding));
  };
  const bool turned = drive.turned_rad >= kLeastTurned_rad && drive.turn_scale.sigma < kScale.most_sigma;
  if (turned) tell(turn_finding(drive));
  const bool tells_direction = drive.distance_scale.value > kSigmas * drive.distance_scale.sigma;  // and the way in it
  if (drive.driven_m < kLeastDriven_m || !tells_direction) return findings;
  if (drive.mount_heading_rad.sigma < kHeading_rad.most_sigma) tell(heading_finding(drive, T_base_laser));
  if (drive.distance_scale.sigma > kScale.most_sigma) return findings;
  tell(distance_finding(drive));
  if (turned && drive.mount_position_sigma_m < kPosition_m.most_sigma) tell(position_finding(drive, T_base_laser));
  return findings;
}

bool is_still_by_scans(const MotionPair& pair) {
  return pair.T_scans.position().norm() < kMoves_m && std::abs(pair.T_scans.heading_rad()) < kMoves_rad;
}

std::vector<SensorFinding> judge_standing(std::span<const MotionPair> standing) {
  double moved_m = 0, turned_rad = 0;
  std::size_t moving = 0;
  for (const MotionPair& pair : standing) {
    if (is_still_by_scans(pair)) continue;
    ++moving;
    moved_m += pair.T_scans.position().norm();
    turned_rad += std::abs(pair.T_scans.heading_rad());
  }
  if (moving < kMovingMotions) return {};
  return {{Subject::standing_odometry, Verdict::contradicted, moved_m, 0, 0,
           fmt::format("scans move by {:.2f} m and turn by {:.2f} rad where odometry stands: does the odometry arrive?",
                       moved_m, turned_rad)}};
}

SensorFinding frozen_odometry(double changed_share) {
  return {Subject::standing_odometry,
          Verdict::contradicted,
          changed_share,
          0,
          0,
          fmt::format("odometry stands still, but {:.0f} % of the beams have changed: do the wheels' counts arrive?",
                      100 * changed_share)};
}

std::vector<SensorFinding> judge_ranges(const RangeHabits& habits, const LaserModel& described) {
  std::vector<SensorFinding> findings;
  if (habits.scans() < kScansOfRanges) return findings;
  const double usable = habits.usable_share();
  if (usable < kFewestUsable)
    findings.push_back(
        {Subject::usable_beams, Verdict::contradicted, usable, 1, 0,
         fmt::format("{:.1f} of 100 beams hit something between {:.2f} and {:.2f} m: are the ranges in metres, and "
                     "the limits those of this laser?",
                     100 * usable, described.range_min_m, std::min(described.range_max_m, described.no_return_m))});
  const auto repeated = habits.repeated_farthest();
  if (repeated && repeated->scan_share > kRepeatedScans && repeated->farther_share < kFartherScans)
    findings.push_back(
        {Subject::no_return, Verdict::contradicted, repeated->range_m, described.no_return_m, 0,
         fmt::format("{:.1f} of 100 beams have exactly the range {:.4g} m, in {:.0f} of 100 scans: that is no hit, but "
                     "no_return_m is described as {:.4g}",
                     100 * repeated->beam_share, repeated->range_m, 100 * repeated->scan_share,
                     described.no_return_m)});
  return findings;
}

}  // namespace opal
