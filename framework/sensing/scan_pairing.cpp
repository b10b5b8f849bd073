#include <opal/sensing/scan_pairing.hpp>

#include "sensing/deskew.hpp"
#include "sensing/laser_rhythm.hpp"
#include "sensing/odometry_track.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace opal {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();

// Odometry that no scan has asked for is forgotten: where a laser is silent, memory must not grow.
constexpr double kLongestTrack_s = 60;

const std::string kImpossibleSweep =
    "time_increment that is too long to be true (sensor.sweep_s of the deployment can state the sweep)";

bool is_finite(const Pose2& pose) { return pose.position().allFinite() && std::isfinite(pose.heading_rad()); }

struct PendingScan {
  int laser = 0;
  Scan scan;
  std::optional<Pose2> T_track_base;  // from the scan's own odometry
  Sweep sweep;
  bool settled = false;  // waits for nothing any more
};

}  // namespace

struct ScanPairing::State {
  State(std::vector<LaserModel> models, const PairingOptions& limits)
      : options(limits),
        track({limits.max_speed_mps, limits.max_turn_radps, limits.jump_m, limits.jump_rad, limits.bridge_jumps}) {
    for (LaserModel& model : models) lasers.push_back({std::move(model), {}, {}, kNever});
  }

  struct Laser {
    LaserModel model;
    RawScan newest;
    LaserRhythm rhythm;
    double last_stamp_s = kNever;  // of this timeline
  };

  std::vector<Laser> lasers;
  PairingOptions options;
  OdometryTrack track;
  std::deque<PendingScan> pending;         // by stamp, within a timeline
  double last_stamp_s = kNever;            // of this timeline
  double last_odometry_s = kNever;         // of records and of scans with their own
  double last_stream_odometry_s = kNever;  // of records
  double last_left_s = kNever;             // stamp of the newest scan that does not wait any more
  Said said;                               // for the next sample
  std::map<std::string, int> counts;

  void take(const MountRecord&) {}
  void take(const HintRecord& record) { said.hint = record.hint; }
  void take(const ForgetRecord&) { said = {.forget = true, .hint = std::nullopt}; }
  void take(const OdometryRecord& odometry);
  void take(const RawScan& raw);
  void advance_clock(double stamp_s, double& last_of_stream_s);
  void restart_clock();
  void count_jump(OdometryTrack::Added added) {
    if (added == OdometryTrack::Added::jumped) ++counts["odometry jump"];
  }
  Laser* laser_of(const RawScan& raw);
  static bool is_doubled(const RawScan& raw, const RawScan& newest) {
    return raw.stamp_s == newest.stamp_s && raw.frame == newest.frame && same_ranges(raw, newest);
  }
  static bool same_ranges(const RawScan& a, const RawScan& b);
  void add_own_odometry(const RawScan& raw, PendingScan& waiting);
  void insert(PendingScan waiting);
  void settle(PendingScan& waiting);
  void settle_all();
  bool has_odometry(const PendingScan& scan) const;
  using Group = std::vector<std::size_t>;  // positions in `pending`, by stamp, one a laser
  Group group_of_front() const;
  bool lacks_laser(const Group& group) const;
  bool may_leave(const Group& group) const;
  std::optional<Sample> release(const Group& group);
  LaserView view_of(PendingScan waiting, const Pose2& T_track_sample) const;
};

void ScanPairing::State::restart_clock() {
  ++counts["clock reset"];
  settle_all();  // what still waits will see no later odometry of its own timeline
  track.restart_clock();
  last_stamp_s = last_odometry_s = last_left_s = kNever;
  last_stream_odometry_s = kNever;
  for (Laser& laser : lasers) laser.rhythm.restart();
  for (Laser& laser : lasers) laser.last_stamp_s = kNever;
}

/// Scans and odometry may be stamped by two clocks that are apart: only a stream that steps back itself tells of a
/// reset.
void ScanPairing::State::advance_clock(double stamp_s, double& last_of_stream_s) {
  if (stamp_s < last_of_stream_s - options.clock_reset_s) restart_clock();
  last_of_stream_s = std::max(last_of_stream_s, stamp_s);
  if (std::isfinite(last_stamp_s) && stamp_s > last_stamp_s + options.gap_s) ++counts["gap"];
  last_stamp_s = std::max(last_stamp_s, stamp_s);
}

void ScanPairing::State::take(const OdometryRecord& odometry) {
  if (!std::isfinite(odometry.stamp_s) || !is_finite(odometry.T_odom_base)) {
    ++counts["odometry that is not finite"];
    return;
  }
  advance_clock(odometry.stamp_s, last_stream_odometry_s);
  if (odometry.stamp_s < last_odometry_s) {
    ++counts["odometry stamp steps back"];
    return;
  }
  if (odometry.stamp_s == last_odometry_s) ++counts["repeated odometry stamp"];
  last_odometry_s = odometry.stamp_s;
  count_jump(track.add(odometry.stamp_s, odometry.T_odom_base));
  track.forget_before(odometry.stamp_s - kLongestTrack_s);
}

bool ScanPairing::State::same_ranges(const RawScan& a, const RawScan& b) {
  return std::equal(a.ranges_m.begin(), a.ranges_m.end(), b.ranges_m.begin(), b.ranges_m.end(),
                    [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

ScanPairing::State::Laser* ScanPairing::State::laser_of(const RawScan& raw) {
  const auto found = std::ranges::find_if(lasers, [&](const Laser& laser) {
    return laser.model.frame == raw.frame || (lasers.size() == 1 && laser.model.frame.empty());
  });
  return found == lasers.end() ? nullptr : &*found;
}

void ScanPairing::State::take(const RawScan& raw) {
  Laser* laser = laser_of(raw);
  if (!laser) {
    ++counts["scan of a laser that is not described"];
    return;
  }
  if (!std::isfinite(raw.stamp_s)) {
    ++counts["scan stamp that is not finite"];
    return;
  }
  advance_clock(raw.stamp_s, laser->last_stamp_s);
  if (raw.stamp_s < last_left_s) {
    ++counts["scan stamp steps back"];
    return;
  }
  if (is_doubled(raw, laser->newest)) {
    ++counts["doubled scan"];
    return;
  }
  laser->newest = raw;
  laser->rhythm.scanned(raw.stamp_s);
  PendingScan waiting{
      static_cast<int>(laser - lasers.data()), make_scan(raw, laser->model), {}, sweep_of(raw, laser->model)};
  if (drop_impossible_times(waiting.sweep, laser->model, laser->rhythm.mean_interval_s())) ++counts[kImpossibleSweep];
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
  const auto timeline = std::ranges::find_if(pending, [](const PendingScan& p) { return !p.settled; });
  const auto after = std::upper_bound(timeline, pending.end(), stamp_s,
                                      [](double stamp, const PendingScan& scan) { return stamp < scan.scan.stamp_s; });
  const double before_s = after == timeline ? last_left_s : std::prev(after)->scan.stamp_s;
  if (before_s == stamp_s && lasers.size() == 1) ++counts["repeated scan stamp"];
  const bool of_same_laser =
      std::any_of(after, pending.end(), [&](const PendingScan& later) { return later.laser == waiting.laser; });
  if (of_same_laser) ++counts["scan out of order"];
  pending.insert(after, std::move(waiting));
  if (pending.size() <= options.most_waiting) return;
  ++counts["too many scans wait for odometry"];
  settle(*std::ranges::find_if(pending, [](const PendingScan& p) { return !p.settled; }));
}

void ScanPairing::State::settle(PendingScan& waiting) {
  if (std::exchange(waiting.settled, true)) return;
  const double stamp_s = waiting.scan.stamp_s;
  if (!waiting.T_track_base) waiting.T_track_base = track.at(stamp_s, options.odometry_wait_s);
  deskew(waiting.scan, waiting.sweep, lasers[static_cast<std::size_t>(waiting.laser)].model.T_base_laser,
         [&](double later_s) { return track.at(stamp_s + later_s, options.odometry_wait_s); });
  track.forget_before(stamp_s);
  last_left_s = stamp_s;
}

void ScanPairing::State::settle_all() {
  for (PendingScan& waiting : pending) settle(waiting);
}

bool ScanPairing::State::has_odometry(const PendingScan& waiting) const {
  const double end_s = waiting.scan.stamp_s + waiting.sweep.duration_s();
  const bool is_placed = waiting.T_track_base && !waiting.sweep.takes_time();
  return waiting.settled || is_placed || track.reaches(end_s) || last_stamp_s > end_s + options.odometry_wait_s;
}

/// The oldest scan, and of each other laser the next one, if it begins within half an interval.
ScanPairing::State::Group ScanPairing::State::group_of_front() const {
  Group group{0};
  const PendingScan& front = pending.front();
  const double until_s = front.scan.stamp_s + lasers[static_cast<std::size_t>(front.laser)].rhythm.interval_s() / 2;
  std::vector<bool> is_in(lasers.size(), false);
  is_in[static_cast<std::size_t>(front.laser)] = true;
  for (std::size_t k = 1; k < pending.size() && group.size() < lasers.size(); ++k) {
    const PendingScan& next = pending[k];
    if (next.scan.stamp_s > until_s || next.settled != front.settled) break;
    if (is_in[static_cast<std::size_t>(next.laser)]) continue;
    is_in[static_cast<std::size_t>(next.laser)] = true;
    group.push_back(k);
  }
  return group;
}

/// Whether a laser that is not in the group will have a scan for it before long.
bool ScanPairing::State::lacks_laser(const Group& group) const {
  const PendingScan& front = pending.front();
  if (front.settled || last_stamp_s > front.scan.stamp_s + options.laser_wait_s) return false;
  const double until_s = front.scan.stamp_s + lasers[static_cast<std::size_t>(front.laser)].rhythm.interval_s() / 2;
  for (std::size_t k = 0; k < lasers.size(); ++k) {
    const bool is_in = std::ranges::any_of(
        group, [&](std::size_t position) { return pending[position].laser == static_cast<int>(k); });
    if (!is_in && lasers[k].rhythm.is_due_until(until_s, last_stamp_s)) return true;
  }
  return false;
}

bool ScanPairing::State::may_leave(const Group& group) const {
  return std::ranges::all_of(group, [&](std::size_t k) { return has_odometry(pending[k]); }) && !lacks_laser(group);
}

LaserView ScanPairing::State::view_of(PendingScan waiting, const Pose2& T_track_sample) const {
  const Pose2& mount = lasers[static_cast<std::size_t>(waiting.laser)].model.T_base_laser;
  const bool is_same = distance_m(*waiting.T_track_base, T_track_sample) == 0 &&
                       angle_between_rad(*waiting.T_track_base, T_track_sample) == 0;
  return {waiting.laser, std::move(waiting.scan),
          is_same ? mount : T_track_sample.inverse() * *waiting.T_track_base * mount};
}

std::optional<Sample> ScanPairing::State::release(const Group& group) {
  std::vector<PendingScan> together;
  for (std::size_t k : group) {
    settle(pending[k]);
    if (pending[k].T_track_base)
      together.push_back(std::move(pending[k]));
    else
      ++counts["scan without odometry"];
  }
  for (auto k = group.rbegin(); k != group.rend(); ++k)
    pending.erase(pending.begin() + static_cast<std::ptrdiff_t>(*k));
  if (together.empty()) return std::nullopt;
  const Pose2 T_track_base = *together.back().T_track_base;
  Sample sample{together.back().scan.stamp_s, T_track_base, {}, track.recorded(T_track_base)};
  for (PendingScan& waiting : together) sample.views.push_back(view_of(std::move(waiting), T_track_base));
  std::ranges::sort(sample.views, {}, &LaserView::laser);
  sample.said = std::exchange(said, {});
  return sample;
}

ScanPairing::ScanPairing(std::vector<LaserModel> lasers, const PairingOptions& options)
    : state_(std::make_unique<State>(std::move(lasers), options)) {}
ScanPairing::~ScanPairing() = default;
ScanPairing::ScanPairing(ScanPairing&&) noexcept = default;
ScanPairing& ScanPairing::operator=(ScanPairing&&) noexcept = default;

void ScanPairing::take(const LogRecord& record) {
  std::visit([this](const auto& kind) { state_->take(kind); }, record);
}

void ScanPairing::finish() { state_->settle_all(); }

std::optional<Sample> ScanPairing::next() {
  State& state = *state_;
  while (!state.pending.empty()) {
    const State::Group group = state.group_of_front();
    if (!state.may_leave(group)) break;
    if (std::optional<Sample> sample = state.release(group)) return sample;
  }
  return std::nullopt;
}

const std::map<std::string, int>& ScanPairing::counts() const { return state_->counts; }

}  // namespace opal
