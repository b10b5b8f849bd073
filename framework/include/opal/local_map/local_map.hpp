#pragma once

#include <opal/common/feature.hpp>
#include <opal/local_map/local_map_ids.hpp>
#include <opal/local_map/scan_matcher.hpp>
#include <opal/sensing/sample.hpp>

#include <deque>
#include <memory>
#include <vector>

namespace opal {

/// One detection of a local feature: the measurement set of a feature is a list of these (thesis 3.4.1).
struct Measurement {
  KeyframeId keyframe = {};  ///< at which it was detected
  Feature feature;           ///< as detected, in the base_link frame at that keyframe
};

/// A feature of the local map, with its measurement set. Frame: `local`.
struct LocalFeature {
  LocalFeatureId id = {};                 ///< unique over a run; never reused
  Feature feature;                        ///< best estimate of all measurements; frame `local`
  std::vector<Measurement> measurements;  ///< oldest first; never empty
  int distinct_poses = 0;                 ///< measurements from poses that differ by the configured distance or angle
  bool stable = false;                    ///< distinct_poses has reached the configured number at some time
  KeyframeId last_keyframe = {};          ///< of the newest measurement
};

/// A pose of the robot that the horizon still holds, with the raw points seen from it.
struct Keyframe {
  KeyframeId id = {};         ///< increasing; ids of keyframes that brought nothing new are missing
  double stamp_s = 0;         ///< of the scan
  Pose2 T_local_base;         ///< the robot's pose, as scan matching and the factor graph improved it
  Pose2 T_odom_base;          ///< what odometry said
  double driven_m = 0;        ///< odometer at this pose; turning counts by LocalMapOptions::horizon_m_per_rad
  std::vector<Point> points;  ///< in base_link [m]; laser after laser, of each by increasing bearing
};

/// When things are forgotten, associated, called stable and optimized; how good odometry is.
struct LocalMapOptions {
  double horizon_m = 6.0;               ///< keyframes older than this much driving are forgotten
  double horizon_m_per_rad = 0.5;       ///< driving that a turn on the spot is worth: turning ages a map, too
  double association_distance_m = 0.3;  ///< points, corners, circles: apart; segments: gap between the two
  double association_offset_m = 0.15;   ///< segments: distance of an end from the other's infinite line
  /// Segments and corners: difference of headings; corners: of openings, too.
  double association_angle_rad = 0.2;
  double association_radius_m = 0.1;            ///< circles: difference of radii
  int stable_after = 3;                         ///< detections from different poses that make a feature stable
  double pose_change_m = 0.05;                  ///< poses that differ by this much, or
  double pose_change_rad = 0.05;                ///< by this much, are different
  int optimize_every = 3;                       ///< keyframes between two runs of the factor graph; 0: never
  double robust_scale = 1.0;                    ///< Cauchy loss, in standard deviations
  double odometry_sigma_m = 0.06;               ///< one-sigma translation error, however short the motion
  double odometry_heading_sigma_rad = 0.1;      ///< one-sigma heading error, however short the motion: recorded scans
                                                ///< and odometry differ in time by up to 0.2 s, 10 degrees in a turn
  double odometry_sigma_per_m = 0.15;           ///< one-sigma translation error per metre driven [m]
  double odometry_heading_sigma_per_rad = 0.2;  ///< one-sigma heading error per radian turned [rad]
  double odometry_heading_sigma_per_m = 0.04;   ///< one-sigma heading error per metre driven [rad]
};

/// A small, locally consistent map of the features seen lately (thesis 3.3.1, Algorithm 1, Appendix A). Its frame,
/// `local`, starts at the robot's first pose and follows dead reckoning as improved by scan matching and a factor
/// graph; it is consistent over the horizon, not over a building.
class OPAL_EXPORT LocalMap {
 public:
  /// An empty map. The matcher may be null: the robot then moves as odometry says.
  LocalMap(LocalMapOptions options, std::shared_ptr<const ScanMatcher> matcher);
  ~LocalMap();
  /// Takes the contents of another map, which must not be used any more.
  LocalMap(LocalMap&&) noexcept;
  /// Takes the contents of another map, which must not be used any more.
  LocalMap& operator=(LocalMap&&) noexcept;

  /// Adds one keyframe (Algorithm 1). A keyframe that does not differ from the one before it (pose_change_m,
  /// pose_change_rad) is replaced by the next one, so a standing robot does not fill the map. Points and features
  /// that are not finite are left out; odometry that is not finite counts as no motion.
  /// @param sample    the scans, with odometry.
  /// @param features  detected in them; base_link frame.
  void add(const Sample& sample, const std::vector<Feature>& features);

  /// Forgets everything; ids go on.
  void clear();
  /// Forgets all features but these. The way here stays, with the points seen from it.
  void keep_only(const std::vector<LocalFeatureId>& ids);

  /// By increasing id. Where two features turn out to be pieces of one, the older id keeps both.
  const std::vector<LocalFeature>& features() const;
  const std::deque<Keyframe>& keyframes() const;  ///< oldest first
  const Pose2& T_local_base() const;              ///< newest pose
  /// Where the newest pose would be at odometry reading `T_odom_base` (between keyframes).
  Pose2 T_local_base_at(const Pose2& T_odom_base) const;
  /// For each feature of the last scan, by its position in `features` given to add: the id of its local feature;
  /// none if the feature was not usable (not finite, or a segment without length).
  const std::vector<LocalFeatureId>& last_associations() const;
  /// The evidence cells, squares of 1 m, that points lie on as the robot stands now. What lies on one evidence cell is
  /// one thing, whatever the map calls it, however long the robot looks at it, and however it moves.
  /// @param points  base_link frame [m].
  std::vector<EvidenceCell> evidence_cells(const std::vector<Point>& points) const;
  /// The last scan match. Without one (converged = false), pose and covariance are odometry's.
  const ScanMatch& last_match() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace opal
