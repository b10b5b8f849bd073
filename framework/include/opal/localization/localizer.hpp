#pragma once

#include <opal/common/named.hpp>
#include <opal/common/stage_times.hpp>
#include <opal/local_map/local_map.hpp>
#include <opal/localization/decision/pose_estimate.hpp>
#include <opal/localization/events/event_stream.hpp>
#include <opal/localization/options/localizer_options.hpp>
#include <opal/localization/scoring/active_scorer.hpp>
#include <opal/localization/scoring/hypothesis.hpp>
#include <opal/localization/scoring/hypothesis_scorer.hpp>
#include <opal/localization/scoring/score.hpp>
#include <opal/map/view/map_view.hpp>
#include <opal/patterns/pattern_template.hpp>
#include <opal/sensing/feature_detector.hpp>
#include <opal/sensing/odometry_scale.hpp>
#include <opal/sensing/pose_hint.hpp>
#include <opal/sensor_health/sensor_finding.hpp>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// When a scan becomes a keyframe: by the odometry since the last one.
struct KeyframeOptions {
  double distance_m = 0.1;  ///< driving after which the next scan is a keyframe
  double angle_rad = 0.2;   ///< turning after which the next scan is a keyframe

  /// Whether a scan is a keyframe after another one. @param before, now  poses of the robot in one frame.
  bool are_apart(const Pose2& before, const Pose2& now) const {
    return opal::distance_m(before, now) > distance_m || angle_between_rad(before, now) > angle_rad;
  }
};

/// Everything a localizer is made of. `Deployment` (deployment.hpp) builds it from files.
struct LocalizerParts {
  std::shared_ptr<const MapView> map;  ///< what the sensor perceives of the building
  std::vector<LaserModel> lasers{1};   ///< the sensors that the scans come from; at least one
  KeyframeOptions keyframes;           ///< how densely scans are taken
  /// How features of several scans are put together.
  LocalMapOptions local_map;
  std::shared_ptr<const ScanMatcher> matcher;     ///< may be null: odometry alone
  std::vector<Named<FeatureDetector>> detectors;  ///< all are asked about every keyframe
  std::vector<Named<PatternTemplate>> patterns;   ///< all are looked for, on the map and in the local map
  std::vector<ActiveScorer> scorers;              ///< one of them decides at least
  LocalizerOptions stages = {};                   ///< options of everything behind the local map
  OdometryScale odometry = {};                    ///< by which odometry is corrected before all else
};

/// The pipeline: scan -> features -> local map -> patterns -> association tree -> scores -> pose. One object per
/// robot and run; `update` is called in time order from one thread.
class OPAL_EXPORT Localizer {
 public:
  /// A robot that has seen nothing yet. `events` may be null; else it must outlive the localizer.
  explicit Localizer(LocalizerParts parts, EventSink* events = nullptr);
  ~Localizer();

  /// Takes what the lasers saw at one time. Never throws for poor scans: that is a status.
  /// @return the estimate if the sample became a keyframe (the robot has moved or turned enough), else nullopt.
  std::optional<PoseEstimate> update(const Sample& sample);

  /// The newest estimate carried on by odometry to now.
  PoseEstimate estimate_at(double stamp_s, const Pose2& T_odom_base) const;

  /// The next sample is a keyframe, and the search looks here, too. A hint is one more place to look at: scans judge
  /// it as they judge every other. A hint that is not finite is left out.
  void hint(const PoseHint& hint);

  /// Forgets hypotheses and local map: the next scan is the first one.
  void reset();

  /// Reduces the local map to what the best hypothesis began with, its pattern, before the robot looks round there
  /// (Hendrikx 2023, 4.3.5, 4.4.2). What hypotheses say of other features they forget with the next keyframe, and say
  /// anew of those seen from then on. Nothing changes while there is no hypothesis.
  void keep_pattern();

  const LocalMap& local_map() const;  ///< as the newest keyframe left it
  const MapView& map() const;         ///< the one it was made with
  /// Alive, best first.
  std::vector<Hypothesis> hypotheses() const;
  /// Latest opinions on a hypothesis, by scorer name; empty if there is no such hypothesis.
  std::map<std::string, Score> scores_of(HypothesisId hypothesis) const;
  /// What the drive says of the sensor description, of all of which it has told enough. While one of them contradicts
  /// it, no estimate is called localized.
  const std::vector<SensorFinding>& sensor_findings() const;
  /// That the map does not explain what the robot sees, as a sentence; empty: it does, or it is too soon to say. An
  /// estimate may be called localized all the same.
  std::string map_doubt() const;
  /// Why the newest status is what it is, in words; empty before the first update.
  const std::string& why() const;
  /// CPU time of the newest keyframe, by stage.
  const StageTimes& last_times() const;
  /// Calls into plugins that threw and were skipped, by type name.
  const std::map<std::string, int>& plugin_failures() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace opal
