#pragma once

#include "benchmark/experiments/integrity/drive_world.hpp"
#include "benchmark/experiments/kit/localized_time.hpp"

#include <opal/localization/events/event_stream.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace opal::experiments {

/// A drive is false if it calls a wrong pose localized for longer than this [s]: a controller acts on it by then.
inline constexpr double kFalseAfter_s = 1;

/// What became of one drive. A pose is right by kRightPose.
struct IntegrityRun {
  LocalizedTime localized;
  std::optional<double> localized_after_m = {};  ///< driven until a right pose was called localized
  std::optional<double> recovered_after_s = {};  ///< the same, since the end of what happened in the middle
  bool is_right = false;                         ///< at the end: localized, and right
  double driven_m = 0, duration_s = 0;
  int answers = 0;

  /// A wrong pose was called localized for longer than kFalseAfter_s.
  bool is_false() const { return localized.longest_wrong_s > kFalseAfter_s; }
};

/// One answer beside the truth, for pictures.
struct JudgedAnswer {
  double stamp_s = 0;
  Pose2 truth, said;
  bool is_localized = false, is_right = false;
};

/// What was driven, and who looks on; all may be empty.
struct IntegrityObserver {
  EventSink* events = nullptr;
  std::function<void(const simulation::Recording&)> begins;  ///< before the first answer
  std::function<void(const JudgedAnswer&)> answered;
};

/// One drive through the core of a live localizer.
IntegrityRun run_drive(const DrawnDrive& drive, const DriveWorld& world, const CampaignRobots& robots,
                       const IntegrityObserver& observer = {});

/// A run as named numbers, as a journal keeps it, and back; what was never reached is absent.
std::map<std::string, double> values_of(const IntegrityRun& run);
IntegrityRun integrity_run_from(const std::map<std::string, double>& values);

}  // namespace opal::experiments
