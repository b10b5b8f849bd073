#pragma once

#include <opal/local_map/scan_matcher.hpp>
#include <opal/sensing/sample.hpp>

#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace opal {

/// Odometry that goes on by scans while the wheels' counts do not arrive. Whether they do not is known a second or more
/// after they have stopped. So the scans since then wait. Then each is laid over one shortly before it, from where a
/// motion that goes on as it was would end.
class OPAL_EXPORT LaserOdometry {
 public:
  /// @param matcher  may be null: then nothing tells what the wheels do not count.
  explicit LaserOdometry(std::shared_ptr<const ScanMatcher> matcher) : matcher_(std::move(matcher)) {}

  /// Takes each sample, keyframe or not.
  /// @param sample     with the wheels' odometry. @param is_frozen  its counts do not arrive.
  void add(const Sample& sample, bool is_frozen);
  /// Motions count from the newest sample: it is where the local map has the robot.
  void begin_at_newest();
  void clear();

  /// Odometry with the motions that the wheels did not count.
  Pose2 at(const Pose2& T_odom_wheels) const { return T_odom_counted_ * T_odom_wheels; }
  /// The scans told the whole motion since the wheels' counts have stopped; also true if they have not.
  bool is_sure() const { return is_sure_; }

 private:
  struct Seen {
    double stamp_s = 0;
    std::vector<Point> points;  ///< base_link frame [m]
  };
  void take_wheels(const Sample& sample);
  void wait(Seen seen);
  ScanMatch laid_over_reference(const Seen& seen) const;
  ScanMatch laid_over_either(const Seen& seen);
  void follow(Seen seen);
  void take_for_reference(Seen seen);

  std::shared_ptr<const ScanMatcher> matcher_;
  std::optional<Pose2> T_odom_wheels_;  ///< the newest reading, or the one at which the wheels stand
  Pose2 T_odom_counted_;                ///< of the frame in which the wheels count: it moves while they stand
  Eigen::Vector3d speed_ = {0, 0, 0};   ///< of the newest motion, base_link frame [m/s, m/s, rad/s]
  Seen reference_;                      ///< what the next scan is laid over
  std::optional<Seen> previous_;        ///< the scan before it, if that is another one
  Pose2 T_odom_reference_;              ///< T_odom_counted_ when it was seen
  Pose2 T_reference_base_;              ///< of the newest scan that was followed
  double stamp_s_ = 0;                  ///< of that scan
  std::deque<Seen> waiting_;            ///< seen since then, while the wheels stand
  bool has_forgotten_ = false;          ///< the wheels stand for longer than scans wait
  double coasted_s_ = 0;                ///< since scans told a motion
  bool is_sure_ = true;
};

}  // namespace opal
