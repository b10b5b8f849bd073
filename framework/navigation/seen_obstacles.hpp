#pragma once

#include "navigation/motion_primitives.hpp"

#include <opal/sensing/scan.hpp>

#include <deque>
#include <unordered_map>
#include <vector>

namespace opal::navigation {

struct ObstacleMemory {
  double cell_m = 0.05;     ///< one point is kept per cell
  double newest_s = 0.35;   ///< where the laser looks, points this old still count for the next motion,
  double unseen_s = 8;      ///< and where it does not look, points this old
  double planning_s = 300;  ///< for planning, unless a beam has passed through since
  double earlier_s = 0.5;   ///< what stands where a beam passed this long ago has moved there
  double moving_s = 1;      ///< what has moved, and what is beside it, may move on for so long
  double waiting_s = 20;    ///< and who has come somewhere is taken for somebody who will go on, for so long
  double berth_m = 0.35;    ///< as far as a leg swings until the next scan
  int scans = 3;            ///< a beam that ends between two depths leaves a point where the next scans see nothing
  double flicker_s = 60;    ///< what came so often within this time, without going on, is glass that some beams pass
};

/// What the laser has seen lately, in the odom frame, so that what is beside and behind the robot is known, too.
class SeenObstacles {
 public:
  explicit SeenObstacles(const ObstacleMemory& memory = {}) : memory_(memory) {}

  /// Takes a scan; what its beams pass through is forgotten.
  void add(const Scan& scan, const Pose2& T_odom_base, const Pose2& T_base_laser);

  /// What the next motion must not touch, frame base_link at the newest scan.
  std::vector<Obstacle> near(double reach_m) const;
  /// What stands within reach of the robot and was seen in several scans, as far as it is not forgotten, frame odom:
  /// for planning.
  std::vector<Point> standing(double reach_m) const;
  /// What moves, or came not long ago and waits, frame odom. It is elsewhere by now, if it was seen some seconds ago:
  /// then it is left out.
  std::vector<Point> moving(double reach_m) const;

 private:
  struct SeenPoint {
    long key;  ///< of its cell
    Point p_odom;
    double stamp_s;
    double moved_s;  ///< when it was seen to move; long ago: never
    int scans;       ///< in which it was seen
  };
  /// Ranges of a scan by direction, in the laser frame; 0: the laser does not look there, or saw nothing.
  struct Sweep {
    Pose2 T_odom_laser;
    double stamp_s = 0;
    std::vector<double> ranges_m;
    double range_at(double bearing_rad, int slack) const;  ///< least of the neighbours; 0: unknown
  };
  static long key_of(const Point& p_odom, double cell_m);
  void sweep(const Scan& scan);
  void forget();
  void drop(std::size_t point);
  enum class Motion { still, moving };
  void see(const Point& p_odom, Motion motion);
  /// Came there not long before it was seen last: somebody who waits.
  bool waits(const SeenPoint& seen) const { return seen.stamp_s - seen.moved_s < memory_.waiting_s; }
  /// Those that pass a test, within reach of the robot. Frame odom.
  template <class Test>
  std::vector<Point> within(double reach_m, Test test) const;
  std::vector<Point> moved(const Scan& scan) const;
  /// Those of what seems to have moved that come again and again at the same place: panes, which stand still.
  void leave_out_panes(std::vector<Point>& movers);

  /// How often something has come into a cell where beams passed before.
  struct Arrivals {
    int count = 0;
    double newest_s = 0;
  };

  ObstacleMemory memory_;
  std::vector<SeenPoint> points_;                   ///< in one piece: all of them are asked at every scan
  std::unordered_map<long, std::size_t> point_of_;  ///< by cell
  std::unordered_map<long, Arrivals> arrivals_;
  Sweep sweep_;                ///< of the newest scan
  std::deque<Sweep> earlier_;  ///< oldest first
  double now_s_ = 0;
  Pose2 T_odom_base_, T_odom_laser_;
};

}  // namespace opal::navigation
