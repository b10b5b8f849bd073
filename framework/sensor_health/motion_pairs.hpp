#pragma once

#include "sensor_health/motion_calibration.hpp"

#include <opal/local_map/scan_matcher.hpp>
#include <opal/sensing/scan.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace opal {

/// Cuts a drive into short motions and lays the scan at the end of each over the one at its beginning. Where the scans
/// lie over each other as odometry and the described mount have it, that is taken. Where they do not, all motions are
/// tried, backwards as well as forwards, and one that fits clearly better is taken. So look-alike places do not speak
/// against a description that is right. Along a corridor scans slide: what fits as well backwards says nothing of the
/// distance, neither for a description nor against it.
class OPAL_EXPORT MotionPairs {
 public:
  /// @param matcher  not null. @param T_base_laser  the described mount.
  MotionPairs(std::shared_ptr<const ScanMatcher> matcher, const Pose2& T_base_laser)
      : matcher_(std::move(matcher)), T_base_laser_(T_base_laser) {}

  /// @param scan  sensor frame. @param T_odom_base  odometry at its stamp.
  /// @return a motion that ends with this scan, if one does and the scans tell it.
  std::optional<MotionPair> add(const Scan& scan, const Pose2& T_odom_base);
  /// Passes by so many motions before the next one is looked at; they cost nothing. A robot that stands by its odometry
  /// is looked at all the same: nothing else tells as soon that the odometry has frozen.
  void skip(int motions) { skipped_ = motions; }
  void clear();

 private:
  void begin_at(const Scan& scan, const Pose2& T_odom_base);
  ScanMatch near(const std::vector<Point>& points, const Pose2& T_laser) const;
  ScanMatch any_way(const std::vector<Point>& points, const Pose2& T_odometry) const;
  // Says whether it has put another motion in the place of `match`.
  bool prefer_backwards(const std::vector<Point>& points, const Pose2& T_described, ScanMatch& match) const;
  std::optional<MotionPair> laid_over(const std::vector<Point>& points, const Pose2& T_odometry) const;

  std::shared_ptr<const ScanMatcher> matcher_;
  Pose2 T_base_laser_;
  std::vector<Point> reference_;  ///< sensor frame at the beginning of the motion
  Pose2 T_odom_reference_;
  double reference_stamp_s_ = 0;
  bool begun_ = false;
  int skipped_ = 0;
};

}  // namespace opal
