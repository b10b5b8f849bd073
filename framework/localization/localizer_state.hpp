#pragma once

#include <opal/localization/localizer.hpp>

#include "local_map/laser_odometry.hpp"
#include "localization/decision/kidnap_detector.hpp"
#include "localization/decision/ride_watch.hpp"
#include "localization/decision/status.hpp"
#include "localization/events/run_journal.hpp"
#include "localization/guarded_parts.hpp"
#include "localization/observation/plugin_failures.hpp"
#include "localization/observation/settling.hpp"
#include "localization/scoring/scorer_ensemble.hpp"
#include "localization/search/map_search.hpp"
#include "localization/tree/hypothesis_set.hpp"
#include "sensor_health/sensor_monitors.hpp"

#include <utility>

namespace opal {

/// What a localizer knows between updates, and the stages of an update, which localizer.cpp has in their order.
struct Localizer::State {
  State(LocalizerParts parts_given, EventSink* sink)
      : parts(guarded(std::move(parts_given), failures)),
        odometry(parts.odometry),
        sensors(parts.lasers, parts.matcher),
        laser_odometry(parts.matcher),
        local_map(parts.local_map, parts.matcher),
        ensemble(parts.scorers, parts.map, failures),
        global_search(parts.map, parts.patterns, ensemble, parts.stages.search),
        journal(sink ? *sink : nobody, parts.map, ensemble, global_search),
        retrospective(parts.map, ensemble, parts.stages.verification, parts.stages.tracking.evidence_memory,
                      parts.stages.status.lead()),
        hypotheses(parts.map, ensemble, parts.stages, journal),
        kidnapping(parts.stages.kidnapping, parts.stages.tracking.evidence_memory),
        rides(parts.map, parts.stages.rides),
        search_session(global_search, parts.stages.schedule),
        status(parts.stages.status, parts.stages.tracking.evidence_memory) {}

  void heed(const Said& said);
  void reset();
  Sample checked(Sample sample);
  void forget_drive();
  bool is_keyframe(const Sample& sample);
  bool fits_no_more(const Sample& sample) const;
  double tempering_weight() const;  ///< of the newest scan
  bool drove_blind() const;         ///< before the newest scan
  PoseEstimate estimate(const Observation& observation);
  void track(const Observation& observation, const Sample& sample);
  void carry();
  std::optional<Pose2> best_pose_at(const Pose2& T_odom_base) const;
  PoseEstimate with_place(PoseEstimate estimate) const;
  void watch(const Observation& observation);
  void settle();
  int searched_every() const;
  void search_map(const Observation& observation, const Sample& sample);
  UnderConstrained under_constrained() const;
  void grow();
  std::vector<LocalFeatureId> pattern_of_best() const;

  NullEventSink nobody;
  PluginFailures failures;
  LocalizerParts parts;
  ScaledOdometry odometry;
  SensorMonitors sensors;
  LaserOdometry laser_odometry;  ///< while the wheels' counts do not arrive
  LocalMap local_map;
  ScorerEnsemble ensemble;
  GlobalSearch global_search;
  RunJournal journal;
  RetrospectiveVerification retrospective;
  HypothesisSet hypotheses;
  ScanAgreement newest_agreement;
  KidnapDetector kidnapping;
  RideWatch rides;
  Settling settling;
  MapSearch search_session;  ///< global searches from scan to scan
  StatusEstimator status;

  bool started = false;
  double stamp_s = 0;
  KeyframeId keyframe;              ///< the newest one
  Pose2 T_odom_base;                ///< at the newest keyframe
  double step_m = 0, turn_rad = 0;  ///< since the previous keyframe
  bool rode = false;                ///< a lift may have carried the robot since it came to rest
  bool search_now = false;          ///< the robot may have been kidnapped, since this scan
  double sensor_s = 0;              ///< CPU time of the sensor check since the newest keyframe
  StageTimes times;
};

}  // namespace opal
