#include "simulation/drives/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

namespace opal::simulation {
namespace {

constexpr double kStep_s = 0.05;

/// One drive under way.
class RecordedDrive {
 public:
  using Goal = std::function<std::optional<Point>()>;  ///< where to go next; none: the drive ends

  RecordedDrive(Simulation& simulation, const DriveOptions& options, Goal goal, Recording& recording)
      : simulation_(simulation),
        options_(options),
        goal_(std::move(goal)),
        recording_(recording),
        follower_(simulation.options().drive, options.follower) {}

  /// From where the robot stands, up to a distance or a time, whichever comes first.
  void run(const std::string& id, double distance_m, double duration_s) {
    const double start_s = simulation_.now_s();
    read(0);
    std::vector<double> next_scan_s = first_scans_s(start_s);
    while (driven_m_ < distance_m && simulation_.now_s() < start_s + duration_s && !is_over_) {
      step();
      for (std::size_t laser = 0; laser < next_scan_s.size(); ++laser) {
        if (simulation_.now_s() + 1e-9 < next_scan_s[laser]) continue;
        next_scan_s[laser] += options_.scan_every_s;
        read(laser);
      }
    }
    recording_.queries.push_back({id, start_s, simulation_.now_s()});
    recording_.distances_m.push_back(driven_m_);
  }

 private:
  /// Lasers scan one after the other, not all at once.
  std::vector<double> first_scans_s(double start_s) const {
    const std::size_t lasers = 1 + recording_.more_lasers.size();
    std::vector<double> next_s;
    for (std::size_t k = 0; k < lasers; ++k)
      next_s.push_back(start_s + options_.scan_every_s * (1 + static_cast<double>(k) / static_cast<double>(lasers)));
    return next_s;
  }

  void read(std::size_t laser) {
    RawScan scan = simulation_.scan(laser);
    if (laser > 0) return recording_.more_scans.push_back(std::move(scan));
    const Pose2 T_map_base = simulation_.T_map_base_at(scan.stamp_s);
    recording_.scans.push_back({std::move(scan), T_map_base});
  }

  void step() {
    const Pose2 before = simulation_.T_map_base();
    if (follower_.arrived()) {
      const std::optional<Point> goal = goal_();
      is_over_ = !goal.has_value();
      if (is_over_) return;
      if (auto way = simulation_.floor().way(before.position(), *goal)) follower_.follow(std::move(*way));
    }
    if (simulation_.drive(follower_.steer(before), kStep_s)) give_way();
    if (recording_.laser.sweep_s || !recording_.more_lasers.empty())
      recording_.odometry.push_back({simulation_.now_s(), simulation_.T_odom_base()});
    driven_m_ += distance_m(before, simulation_.T_map_base());
  }

  /// Somebody stands in the way, or a corner was cut: goes on more closely, and at last elsewhere.
  void give_way() {
    ++recording_.stops;
    constexpr int kPatience = 40;
    if (++waited_ % kPatience == 0)
      follower_.follow({});
    else
      follower_.keep_close();
  }

  Simulation& simulation_;
  const DriveOptions& options_;
  Goal goal_;
  Recording& recording_;
  PathFollower follower_;
  double driven_m_ = 0;
  int waited_ = 0;
  bool is_over_ = false;
};

Recording recording_by(const Simulation& simulation) {
  Recording recording;
  recording.laser = simulation.options().laser;
  recording.more_lasers = simulation.options().more_lasers;
  return recording;
}

constexpr double kForever = std::numeric_limits<double>::infinity();

}  // namespace

void carry_on(RawScan& scan, double later_s, const Pose2& T_odom_odom) {
  scan.stamp_s += later_s;
  if (scan.T_odom_base) scan.T_odom_base = T_odom_odom * *scan.T_odom_base;
}

std::string query_name(int number) { return fmt::format("q{:02}", number); }

Recording record(Simulation& simulation, const DriveOptions& options, Random random) {
  Recording recording = recording_by(simulation);
  const auto anywhere = [&] { return simulation.floor().anywhere(random); };
  const double longest_s = 30 + 8 * options.distance_m / options.follower.speed_mps;
  for (int k = 1; k <= options.drives; ++k) {
    const Point start = anywhere();
    simulation.place({start, random.uniform(-std::numbers::pi, std::numbers::pi)});
    RecordedDrive(simulation, options, anywhere, recording).run(query_name(k), options.distance_m, longest_s);
    simulation.drive({}, options.pause_s);
  }
  return recording;
}

Recording record_route(Simulation& simulation, const std::vector<Point>& places, double duration_s,
                       const DriveOptions& options, Random random) {
  Recording recording = recording_by(simulation);
  std::size_t next = 0;
  const auto goal = [&] {
    return simulation.floor().nearest(places[next++ % places.size()]).value_or(simulation.floor().anywhere(random));
  };
  const Point start = goal();
  simulation.place({start, random.uniform(-std::numbers::pi, std::numbers::pi)});
  RecordedDrive(simulation, options, goal, recording).run(query_name(1), kForever, duration_s);
  return recording;
}

Recording record_about(Simulation& simulation, double duration_s, const DriveOptions& options, Random random) {
  constexpr int kPlaces = 20;
  std::vector<Point> places;
  for (int k = 0; k < kPlaces; ++k) places.push_back(simulation.floor().anywhere(random));
  return record_route(simulation, places, duration_s, options, random.branch());
}

Recording record_way(Simulation& simulation, const std::vector<Point>& places, double most_s,
                     const DriveOptions& options) {
  Recording recording = recording_by(simulation);
  std::size_t next = 0;
  const auto goal = [&]() -> std::optional<Point> {
    if (next == places.size()) return std::nullopt;
    return places[next++];
  };
  RecordedDrive(simulation, options, goal, recording).run(query_name(1), kForever, most_s);
  return recording;
}

Recording record_along(Simulation& simulation, std::span<const StampedPose> T_map_laser) {
  Recording recording;
  recording.laser = simulation.options().laser;
  const Pose2 T_laser_base = recording.laser.T_base_laser.inverse();
  double driven_m = 0;
  for (const StampedPose& stamped : T_map_laser) {
    const Pose2 next = stamped.pose * T_laser_base;
    if (recording.scans.empty())
      simulation.place(next);
    else
      driven_m += distance_m(simulation.T_map_base(), next);
    simulation.follow(next, stamped.stamp_s);
    RawScan scan = simulation.scan();
    const Pose2 T_map_base = simulation.T_map_base_at(scan.stamp_s);
    recording.scans.push_back({std::move(scan), T_map_base});
  }
  if (recording.scans.empty()) return recording;
  recording.queries.push_back(
      {query_name(1), recording.scans.front().scan.stamp_s, recording.scans.back().scan.stamp_s});
  recording.distances_m.push_back(driven_m);
  return recording;
}

bool was_kidnapped(const Pose2& before, const Pose2& after) {
  constexpr double kFarthest_m = 1;  // that a robot drives from scan to scan
  return distance_m(before, after) >= kFarthest_m;
}

Pose2 truth_at(const Recording& recording, double stamp_s) {
  const auto& scans = recording.scans;
  const auto after = std::lower_bound(scans.begin(), scans.end(), stamp_s,
                                      [](const auto& scan, double stamp) { return scan.scan.stamp_s < stamp; });
  if (after == scans.begin()) return scans.front().T_map_base;
  const auto& before = *std::prev(after);
  if (after == scans.end()) return before.T_map_base;
  if (was_kidnapped(before.T_map_base, after->T_map_base))
    return stamp_s < after->scan.stamp_s ? before.T_map_base : after->T_map_base;
  const double share = (stamp_s - before.scan.stamp_s) / (after->scan.stamp_s - before.scan.stamp_s);
  return interpolated(before.T_map_base, after->T_map_base, share);
}

}  // namespace opal::simulation
