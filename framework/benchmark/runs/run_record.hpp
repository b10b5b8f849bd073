#pragma once

#include <opal/localization/localizer.hpp>
#include <opal/sensing/replay.hpp>
#include "evaluation/results.hpp"
#include "sensing/trajectory.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace opal::benchmark {

/// How far a replay had come, since its first scan and as odometry tells it.
struct ReplayProgress {
  double time_s = 0, driven_m = 0;
};

/// What one replay of a log through a localizer leaves behind.
struct RunRecord {
  ReplayProgress whole;                           ///< of the newest replay
  std::optional<ReplayProgress> localized_after;  ///< of the newest replay: until the first scan that was `localized`

  std::vector<opal::ResultRow> rows;               ///< one per scan that had a pose
  std::vector<opal::AlternativeRow> alternatives;  ///< of the same scans
  std::vector<opal::StampedPose> trajectory;       ///< T_map_base, the same scans
  std::vector<double> update_cpu_ms;               ///< per keyframe: cleaning, detection and everything after
  opal::StageTimes stages;                         ///< sums
  double hypotheses = 0;                           ///< sum over keyframes
  opal::PoseEstimate last;
  std::vector<opal::Point> last_points;  ///< of the last keyframe's scan, laser frame
  opal::Pose2 last_T_odom_base;

  void append(const RunRecord& other);
};

/// Who looks on while a log is replayed; all may be empty.
struct RunObserver {
  std::function<bool(double stamp_s)> ready;             ///< before every scan; false ends the replay
  std::function<void(double share)> progress;            ///< after every scan of a replay
  std::function<void(const RunRecord& so_far)> updated;  ///< after every keyframe
};

/// Gives one sample after the other, and nothing at the end.
using SampleSource = std::function<std::optional<opal::Sample>()>;

/// Plays samples through a localizer that has been reset.
RunRecord run_samples(opal::Localizer& localizer, const opal::LaserModel& laser, const SampleSource& next,
                      const std::string& query, const RunObserver& observer = {});
/// The same with a replay.
RunRecord run_log(opal::Localizer& localizer, const opal::LaserModel& laser, opal::Replay& replay,
                  const std::string& query, const RunObserver& observer = {});

}  // namespace opal::benchmark
