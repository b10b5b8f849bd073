#include <opal/sensing/scan_pairing.hpp>

#include "sensing/deskew.hpp"
#include "sensing/odometry_track.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace opal {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();

bool is_finite(const Pose2& pose) { return pose.position().allFinite() && std::isfinite(pose.heading_rad()); }

struct PendingScan {
  Scan scan;
  std::optional<Pose2> T_track_base;  // from the scan's own odometry
  Sweep sweep;
  bool settled = false;  // waits for nothing any more
};

}  // namespace

struct ScanPairing::State {
  State(const LaserModel& model, const PairingOptions& limits)
      : laser(model),
        options(limits),
        track({limits.max_speed_mps, limits.max_turn_radps, limits.jump_m, limits.jump_rad, limits.bridge_jumps}) {}

  LaserModel laser;
  PairingOptions options;
  OdometryTrack track;
  std::deque<PendingScan> pending;  // by stamp, within a timeline
  double last_stamp_s = kNever;     // of this timeline
  double last_odometry_s = kNever;
  double last_left_s = kNever;  // stamp of the newest scan that does not wait any more
  RawScan newest;
  std::map<std::string, int> counts;

  void take(const MountRecord&) {}
  void take(const OdometryRecord& odometry);
  void take(const RawScan& raw);
  void advance_clock(double stamp_s);
  void restart_clock();
  void count_jump(OdometryTrack::Added added) {
    if (added == OdometryTrack::Added::jumped) ++counts["odometry jump"];
  }
  bool is_doubled(const RawScan& raw) const {
    return raw.stamp_s == newest.stamp_s && raw.frame == newest.frame && same_ranges(raw, newest);
  }
  static bool same_ranges(const RawScan& a, const RawScan& b);
  void add_own_odometry(const RawScan& raw, PendingScan& waiting);
  void insert(PendingScan waiting);
  void settle(PendingScan& waiting);
  void settle_all();
  bool may_leave(const PendingScan& scan) const;
  std::optional<Sample> release_front();
};

void ScanPairing::State::restart_clock() {
  ++counts["clock reset"];
  settle_all();  // what still waits will see no later odometry of its own timeline
  track.restart_clock();
  last_stamp_s = last_odometry_s = last_left_s = kNever;
}

void ScanPairing::State::advance_clock(double stamp_s) {
  if (stamp_s < last_stamp_s - options.clock_reset_s) restart_clock();
  if (std::isfinite(last_stamp_s) && stamp_s > last_stamp_s + options.gap_s) ++counts["gap"];
  last_stamp_s = std::max(last_stamp_s, stamp_s);
}

void ScanPairing::State::take(const OdometryRecord& odometry) {
  if (!std::isfinite(odometry.stamp_s) || !is_finite(odometry.T_odom_base)) {
    ++counts["odometry that is not finite"];
    return;
  }
  advance_clock(odometry.stamp_s);
  if (odometry.stamp_s < last_odometry_s) {
    ++counts["odometry stamp steps back"];
    return;
  }
  if (odometry.stamp_s == last_odometry_s) ++counts["repeated odometry stamp"];
  last_odometry_s = odometry.stamp_s;
  count_jump(track.add(odometry.stamp_s, odometry.T_odom_base));
}

bool ScanPairing::State::same_ranges(const RawScan& a, const RawScan& b) {
  return std::equal(a.ranges_m.begin(), a.ranges_m.end(), b.ranges_m.begin(), b.ranges_m.end(),
                    [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

void ScanPairing::State::take(const RawScan& raw) {
  if (!std::isfinite(raw.stamp_s)) {
    ++counts["scan stamp that is not finite"];
    return;
  }
  advance_clock(raw.stamp_s);
  if (raw.stamp_s < last_left_s) {
    ++counts["scan stamp steps back"];
    return;
  }
  if (is_doubled(raw)) {
    ++counts["doubled scan"];
    return;
  }
  newest = raw;
  PendingScan waiting{make_scan(raw, laser), {}, sweep_of(raw, laser)};
  if (waiting.scan.points.empty() && waiting.scan.free_bearings_rad.empty()) ++counts["scan without a valid beam"];
  add_own_odometry(raw, waiting);
  insert(std::move(waiting));
}

/// A sweep is corrected by the odometry of the scans before and after it, if the log has no other.
void ScanPairing::State::add_own_odometry(const RawScan& raw, PendingScan& waiting) {
  if (!raw.T_odom_base || !is_finite(*raw.T_odom_base)) return;
  const bool is_newer = raw.stamp_s >= last_odometry_s;
  if (waiting.sweep.takes_time() && is_newer) last_odometry_s = raw.stamp_s;
  count_jump(waiting.sweep.takes_time() && is_newer ? track.add(raw.stamp_s, *raw.T_odom_base)
                                                    : track.step_to(raw.stamp_s, *raw.T_odom_base));
  waiting.T_track_base = track.continuous(*raw.T_odom_base);
}

void ScanPairing::State::insert(PendingScan waiting) {
  const double stamp_s = waiting.scan.stamp_s;
  const auto timeline = std::find_if(pending.begin(), pending.end(), [](const PendingScan& p) { return !p.settled; });
  const auto after = std::upper_bound(timeline, pending.end(), stamp_s,
                                      [](double stamp, const PendingScan& scan) { return stamp < scan.scan.stamp_s; });
  const double before_s = after == timeline ? last_left_s : std::prev(after)->scan.stamp_s;
  if (before_s == stamp_s) ++counts["repeated scan stamp"];
  if (after != pending.end()) ++counts["scan out of order"];
  pending.insert(after, std::move(waiting));
  if (pending.size() <= options.most_waiting) return;
  ++counts["too many scans wait for odometry"];
  settle(*std::find_if(pending.begin(), pending.end(), [](const PendingScan& p) { return !p.settled; }));
}

void ScanPairing::State::settle(PendingScan& waiting) {
  if (std::exchange(waiting.settled, true)) return;
  const double stamp_s = waiting.scan.stamp_s;
  if (!waiting.T_track_base) waiting.T_track_base = track.at(stamp_s, options.odometry_wait_s);
  deskew(waiting.scan, waiting.sweep, laser.T_base_laser,
         [&](double later_s) { return track.at(stamp_s + later_s, options.odometry_wait_s); });
  track.forget_before(stamp_s);
  last_left_s = stamp_s;
}

void ScanPairing::State::settle_all() {
  for (PendingScan& waiting : pending) settle(waiting);
}

bool ScanPairing::State::may_leave(const PendingScan& waiting) const {
  const double end_s = waiting.scan.stamp_s + waiting.sweep.duration_s();
  const bool is_placed = waiting.T_track_base && !waiting.sweep.takes_time();
  return waiting.settled || is_placed || track.reaches(end_s) || last_stamp_s > end_s + options.odometry_wait_s;
}

std::optional<Sample> ScanPairing::State::release_front() {
  PendingScan waiting = std::move(pending.front());
  pending.pop_front();
  settle(waiting);
  if (!waiting.T_track_base) {
    ++counts["scan without odometry"];
    return std::nullopt;
  }
  return Sample{std::move(waiting.scan), *waiting.T_track_base};
}

ScanPairing::ScanPairing(const LaserModel& laser, const PairingOptions& options)
    : state_(std::make_unique<State>(laser, options)) {}
ScanPairing::~ScanPairing() = default;
ScanPairing::ScanPairing(ScanPairing&&) noexcept = default;
ScanPairing& ScanPairing::operator=(ScanPairing&&) noexcept = default;

void ScanPairing::take(const LogRecord& record) {
  std::visit([this](const auto& kind) { state_->take(kind); }, record);
}

void ScanPairing::finish() { state_->settle_all(); }

std::optional<Sample> ScanPairing::next() {
  State& state = *state_;
  while (!state.pending.empty() && state.may_leave(state.pending.front()))
    if (std::optional<Sample> sample = state.release_front()) return sample;
  return std::nullopt;
}

const std::map<std::string, int>& ScanPairing::counts() const { return state_->counts; }

}  // namespace opal
