#pragma once

#include <opal/common/geometry.hpp>

#include <deque>

namespace opal::simulation {

/// Where a robot was a moment ago, and where its odometry had it.
class MotionMemory {
 public:
  struct Moment {
    double stamp_s = 0;
    Pose2 T_map_base, T_odom_base;
  };

  /// @param keep_s  what is older is forgotten.
  void add(const Moment& now, double keep_s);
  void clear() { moments_.clear(); }
  bool empty() const { return moments_.empty(); }
  /// Between two moments; the nearest one beyond them. Not to be asked while it is empty.
  Moment at(double stamp_s) const;

 private:
  std::deque<Moment> moments_;  ///< by stamp
};

}  // namespace opal::simulation
