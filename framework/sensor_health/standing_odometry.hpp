#pragma once

#include <opal/sensing/scan.hpp>

#include <optional>
#include <vector>

namespace opal {

/// Notices wheels whose counts have frozen: odometry stands still, and most beams of the laser have changed all the
/// same. It needs no scan matcher, so it tells within a second or two.
class OPAL_EXPORT StandingOdometry {
 public:
  /// @param scan  sensor frame. @param T_odom_base  odometry at its stamp.
  void add(const Scan& scan, const Pose2& T_odom_base);
  void clear() { *this = {}; }
  /// Share of the beams that have changed while odometry stood; 0 if it moves, or has not stood for long enough.
  double changed_share() const { return changed_share_; }
  /// So many have changed that the robot must have moved.
  bool is_frozen() const;

 private:
  struct View {
    double stamp_s;
    std::vector<double> ranges_m;  ///< by beam; infinite: no return
  };
  static View view_of(const Scan& scan);
  static double share_changed(const View& before, const View& now);

  std::optional<Pose2> T_odom_base_;  ///< where it stands
  std::optional<View> seen_;          ///< since it stands there
  double changed_share_ = 0;
};

}  // namespace opal
