#include "cli/track/track_run.hpp"

#include <opal/common/quantile.hpp>

#include "common/stage_clock.hpp"

#include <algorithm>

namespace opal::cli {

TrackedWindow track_window(PoseTracker& tracker, const LaserModel& laser, Replay& replay, const std::string& id,
                           const StartAt& start_at, const std::stop_token& stop) {
  TrackedWindow window;
  window.id = id;
  std::optional<Pose2> T_map_odom;
  double before_s = thread_cpu_s();
  while (const auto sample = replay.next()) {
    window.is_cut = stop.stop_requested();
    if (window.is_cut) break;
    const double stamp_s = sample->stamp_s;
    if (!T_map_odom) {
      const auto start = start_at(stamp_s);
      if (!start) continue;
      tracker.start(start->T_map_base, start->sigma);
      T_map_odom = start->T_map_base * sample->T_odom_base.inverse();
    }
    if (tracker.update(*sample)) window.update_cpu_ms.push_back(1e3 * (thread_cpu_s() - before_s));
    const Pose2 T_map_base = tracker.T_map_base_at(sample->T_odom_base);
    window.trajectory.push_back({stamp_s, T_map_base});
    window.rows.push_back(
        {id, stamp_s, T_map_base * laser.T_base_laser, tracker.last().lost ? Status::lost : Status::localized});
    window.dead_reckoned.push_back({id, stamp_s, *T_map_odom * sample->T_odom_base * laser.T_base_laser});
    window.last_points.clear();
    for (const LaserView& view : sample->views)
      for (const ScanPoint& point : view.scan.points)
        window.last_points.push_back(T_map_base * view.T_base_laser * point.position);
    before_s = thread_cpu_s();
  }
  window.track = tracker.track();
  window.last = tracker.last();
  return window;
}

TrackErrors errors_of(const std::vector<ResultRow>& rows, const GroundTruth& truth) {
  std::vector<double> errors_m;
  for (const ResultRow& row : rows)
    if (const auto pose = truth.T_map_laser_at(row.stamp_s)) errors_m.push_back(distance_m(*pose, row.T_map_laser));
  if (errors_m.empty()) return {};
  std::sort(errors_m.begin(), errors_m.end());
  return {errors_m.size(), errors_m.back(), *quantile_of(errors_m, 0.95), *quantile_of(errors_m, 0.5)};
}

}  // namespace opal::cli
