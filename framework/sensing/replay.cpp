#include <opal/sensing/replay.hpp>

#include "sensing/log_check.hpp"

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

}  // namespace

struct Replay::State {
  State(Records log, std::vector<LaserModel> lasers, const ReplayOptions& limits)
      : records(std::move(log)), options(limits), pairing(std::move(lasers), limits.pairing) {}

  Records records;
  ReplayOptions options;
  ScanPairing pairing;

  /// Mounts hold for the whole log, and before the time that is played nothing is there to forget. What is stamped by
  /// no number is the pairing's to count.
  bool is_played(const MountRecord&) const { return true; }
  bool is_played(const ForgetRecord&) const { return true; }
  template <class Stamped>
  bool is_played(const Stamped& record) const {
    return !(record.stamp_s < options.from_s || record.stamp_s > options.to_s);
  }
};

Replay::Replay(std::unique_ptr<LogReader> reader, std::vector<LaserModel> lasers, const ReplayOptions& options)
    : state_(std::make_unique<State>(Records(std::move(reader)), std::move(lasers), options)) {}
Replay::Replay(std::span<const LogRecord> records, std::vector<LaserModel> lasers, const ReplayOptions& options)
    : state_(std::make_unique<State>(Records(records), std::move(lasers), options)) {}
Replay::~Replay() = default;
Replay::Replay(Replay&&) noexcept = default;
Replay& Replay::operator=(Replay&&) noexcept = default;

std::optional<Sample> Replay::next() {
  State& state = *state_;
  while (true) {
    if (std::optional<Sample> sample = state.pairing.next()) return sample;
    const LogRecord* record = state.records.next();
    if (!record) break;
    if (std::visit([&state](const auto& kind) { return state.is_played(kind); }, *record)) state.pairing.take(*record);
  }
  state.pairing.finish();
  return state.pairing.next();
}

std::map<std::string, int> Replay::counts() const {
  std::map<std::string, int> all = state_->pairing.counts();
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
  const RawScan* first = first_with_geometry(records, laser);
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
