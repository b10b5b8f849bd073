#include <opal/sensing/replay.hpp>

#include "sensing/log_check.hpp"
#include "sensing/odometry_track.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

namespace opal {
namespace {

/// The records of a reader, or of a span: one at a time, without copying those of a span.
class Records {
 public:
  explicit Records(std::unique_ptr<LogReader> reader) : reader_(std::move(reader)) {}
  explicit Records(std::span<const LogRecord> records) : records_(records) {}

  /// @return null at the end; valid until the next call.
  const LogRecord* next() {
    if (!reader_) return position_ < records_.size() ? &records_[position_++] : nullptr;
    current_ = reader_->next();
    return current_ ? &*current_ : nullptr;
  }
  std::map<std::string, int> defects() const { return reader_ ? reader_->defects() : std::map<std::string, int>(); }
  double progress() const {
    if (reader_) return reader_->progress();
    return records_.empty() ? 1.0 : static_cast<double>(position_) / static_cast<double>(records_.size());
  }

 private:
  std::unique_ptr<LogReader> reader_;
  std::optional<LogRecord> current_;
  std::span<const LogRecord> records_;
  std::size_t position_ = 0;
};

bool is_finite(const Pose2& pose) { return pose.position().allFinite() && std::isfinite(pose.heading_rad()); }

struct PendingScan {
  Scan scan;
  std::optional<Pose2> T_track_base;  // from the scan's own odometry
};

constexpr double kNever = -std::numeric_limits<double>::infinity();

}  // namespace

struct Replay::State {
  State(Records log, const LaserModel& model, const ReplayOptions& limits)
      : records(std::move(log)),
        laser(model),
        options(limits),
        track({limits.max_speed_mps, limits.max_turn_radps, limits.jump_m, limits.jump_rad, limits.bridge_jumps}) {}

  Records records;
  LaserModel laser;
  ReplayOptions options;
  OdometryTrack track;
  std::deque<PendingScan> pending;  // by stamp, within a timeline
  std::size_t flush = 0;            // so many of them are of an earlier timeline: nothing to wait for
  double last_stamp_s = kNever;     // of this timeline
  double last_odometry_s = kNever;
  double last_scan_s = kNever;
  std::map<std::string, int> counts;

  void take(const MountRecord&) {}
  void take(const OdometryRecord& odometry);
  void take(const RawScan& raw);
  bool in_window(double stamp_s) const { return stamp_s >= options.from_s && stamp_s <= options.to_s; }
  void advance_clock(double stamp_s);
  void restart_clock();
  void count_jump(OdometryTrack::Added added) {
    if (added == OdometryTrack::Added::jumped) ++counts["odometry jump"];
  }
  bool may_leave(const PendingScan& scan) const;
  std::optional<Sample> release_front();
};

void Replay::State::restart_clock() {
  ++counts["clock reset"];
  // What still waits will see no later odometry of its own timeline.
  for (PendingScan& waiting : pending)
    if (!waiting.T_track_base) waiting.T_track_base = track.at(waiting.scan.stamp_s, options.odometry_wait_s);
  flush = pending.size();
  track.restart_clock();
  last_stamp_s = last_odometry_s = last_scan_s = kNever;
}

void Replay::State::advance_clock(double stamp_s) {
  if (stamp_s < last_stamp_s - options.clock_reset_s) restart_clock();
  if (std::isfinite(last_stamp_s) && stamp_s > last_stamp_s + options.gap_s) ++counts["gap"];
  last_stamp_s = std::max(last_stamp_s, stamp_s);
}

void Replay::State::take(const OdometryRecord& odometry) {
  if (!std::isfinite(odometry.stamp_s) || !is_finite(odometry.T_odom_base)) {
    ++counts["odometry that is not finite"];
    return;
  }
  if (!in_window(odometry.stamp_s)) return;
  advance_clock(odometry.stamp_s);
  if (odometry.stamp_s < last_odometry_s) {
    ++counts["odometry stamp steps back"];
    return;
  }
  if (odometry.stamp_s == last_odometry_s) ++counts["repeated odometry stamp"];
  last_odometry_s = odometry.stamp_s;
  count_jump(track.add(odometry.stamp_s, odometry.T_odom_base));
}

void Replay::State::take(const RawScan& raw) {
  if (!std::isfinite(raw.stamp_s)) {
    ++counts["scan stamp that is not finite"];
    return;
  }
  if (!in_window(raw.stamp_s)) return;
  advance_clock(raw.stamp_s);
  if (raw.stamp_s < last_scan_s) {
    ++counts["scan stamp steps back"];
    return;
  }
  if (raw.stamp_s == last_scan_s) ++counts["repeated scan stamp"];
  last_scan_s = raw.stamp_s;
  PendingScan waiting{make_scan(raw, laser), {}};
  if (waiting.scan.points.empty() && waiting.scan.free_bearings_rad.empty()) ++counts["scan without a valid beam"];
  if (raw.T_odom_base && is_finite(*raw.T_odom_base)) {
    count_jump(track.step_to(raw.stamp_s, *raw.T_odom_base));
    waiting.T_track_base = track.continuous(*raw.T_odom_base);
  }
  pending.push_back(std::move(waiting));
}

bool Replay::State::may_leave(const PendingScan& waiting) const {
  return flush > 0 || waiting.T_track_base || track.reaches(waiting.scan.stamp_s) ||
         last_stamp_s > waiting.scan.stamp_s + options.odometry_wait_s;
}

std::optional<Sample> Replay::State::release_front() {
  PendingScan waiting = std::move(pending.front());
  pending.pop_front();
  if (flush > 0) {
    --flush;
  } else {
    if (!waiting.T_track_base) waiting.T_track_base = track.at(waiting.scan.stamp_s, options.odometry_wait_s);
    track.forget_before(waiting.scan.stamp_s);
  }
  if (!waiting.T_track_base) {
    ++counts["scan without odometry"];
    return std::nullopt;
  }
  return Sample{std::move(waiting.scan), *waiting.T_track_base};
}

Replay::Replay(std::unique_ptr<LogReader> reader, const LaserModel& laser, const ReplayOptions& options)
    : state_(std::make_unique<State>(Records(std::move(reader)), laser, options)) {}
Replay::Replay(std::span<const LogRecord> records, const LaserModel& laser, const ReplayOptions& options)
    : state_(std::make_unique<State>(Records(records), laser, options)) {}
Replay::~Replay() = default;
Replay::Replay(Replay&&) noexcept = default;
Replay& Replay::operator=(Replay&&) noexcept = default;

std::optional<Sample> Replay::next() {
  State& state = *state_;
  bool at_end = false;
  while (true) {
    while (!state.pending.empty() && (at_end || state.may_leave(state.pending.front())))
      if (std::optional<Sample> sample = state.release_front()) return sample;
    if (at_end) return std::nullopt;
    const LogRecord* record = state.records.next();
    if (record)
      std::visit([&state](const auto& kind) { state.take(kind); }, *record);
    else
      at_end = true;
  }
}

std::map<std::string, int> Replay::counts() const {
  std::map<std::string, int> all = state_->counts;
  for (const auto& [cause, times] : state_->records.defects()) all[cause] += times;
  return all;
}

double Replay::progress() const { return state_->records.progress(); }

std::vector<Sample> read_all(Replay& replay) {
  std::vector<Sample> samples;
  while (std::optional<Sample> sample = replay.next()) samples.push_back(std::move(*sample));
  return samples;
}

std::vector<LogRecord> read_all(LogReader& reader) {
  std::vector<LogRecord> records;
  while (std::optional<LogRecord> record = reader.next()) records.push_back(std::move(*record));
  return records;
}

LaserModel with_log_geometry(const LaserModel& laser, std::span<const LogRecord> records) {
  LaserModel model = laser;
  if (!laser.geometry_from_log) return model;
  const RawScan* first = first_with_geometry(records);
  if (!first) return model;
  model.angle_min_rad = *first->angle_min_rad;
  model.angle_increment_rad = *first->angle_increment_rad;
  model.beams = static_cast<int>(first->ranges_m.size());
  for (const LogRecord& record : records)
    if (const auto* mount = std::get_if<MountRecord>(&record); mount && mount->child == first->frame)
      model.T_base_laser = mount->T_parent_child;
  return model;
}

}  // namespace opal
