#include "live/stream_health.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

using Level = HealthFinding::Level;

constexpr double kSilentIntervals = 5;
constexpr double kShare = 0.1, kUsualShare = 0.01;  // of a new value in an average
constexpr int kKnown = 50;                          // records that tell a rate
constexpr double kSlower = 1.3;
constexpr int kFewRecords = 5;       // that tell whether two clocks are apart
constexpr double kClockReset_s = 1;  // stamps that step back so far go by another clock than before

double stamp_of(const LogRecord& record) {
  if (const auto* odometry = std::get_if<OdometryRecord>(&record)) return odometry->stamp_s;
  if (const auto* scan = std::get_if<RawScan>(&record)) return scan->stamp_s;
  return std::numeric_limits<double>::quiet_NaN();
}

/// Whose trouble a count is.
std::string subject_of(const std::string& cause) {
  if (cause.find("clock") != std::string::npos) return "clock";
  return cause.find("odometry") != std::string::npos ? "odometry" : "scans";
}

}  // namespace

StreamHealth::StreamHealth(const std::vector<LaserModel>& lasers, const LiveOptions& options)
    : options_(options), lasers_(lasers) {
  for (std::size_t k = 0; k < lasers.size(); ++k)
    scans_.push_back({lasers.size() > 1 ? "laser " + name_of(lasers[k], k) : "laser", "scan"});
}

StreamHealth::Stream* StreamHealth::stream_of(const LogRecord& record) {
  if (std::holds_alternative<OdometryRecord>(record)) return &odometry_;
  const auto* scan = std::get_if<RawScan>(&record);
  if (!scan) return nullptr;
  for (std::size_t k = 0; k < lasers_.size(); ++k)
    if (lasers_[k].frame == scan->frame || (lasers_.size() == 1 && lasers_[k].frame.empty())) return &scans_[k];
  return nullptr;
}

void StreamHealth::hear(Stream& stream, double received_s, double stamp_s, double now_s) {
  const double age_s = now_s - stamp_s, ahead_s = stamp_s - received_s;
  if (stream.received_s) {
    const double since_s = received_s - *stream.received_s;
    stream.interval_s = stream.interval_s > 0 ? (1 - kShare) * stream.interval_s + kShare * since_s : since_s;
    // A mean at first: records that waited for the map come all at once.
    const double share = std::max(kUsualShare, 1.0 / stream.records);
    stream.usual_s = (1 - share) * stream.usual_s + share * since_s;
  }
  if (std::isfinite(age_s)) stream.age_s = stream.received_s ? (1 - kShare) * stream.age_s + kShare * age_s : age_s;
  const double behind_s = stream.received_s ? stream.stamp_ahead_s - ahead_s : 0;
  const bool is_delayed = behind_s > 0 && behind_s < kClockReset_s;
  stream.stamp_ahead_s = is_delayed ? (1 - kShare) * stream.stamp_ahead_s + kShare * ahead_s : ahead_s;
  stream.received_s = received_s;
  ++stream.records;
}

void StreamHealth::take(const LogRecord& record, double received_s, double now_s) {
  if (!begun_s_) begun_s_ = received_s;
  Stream* stream = stream_of(record);
  if (!stream) return;
  // An own odometry in every scan is odometry, too.
  if (const auto* scan = std::get_if<RawScan>(&record); scan && scan->T_odom_base)
    hear(odometry_, received_s, scan->stamp_s, now_s);
  hear(*stream, received_s, stamp_of(record), now_s);
}

void StreamHealth::note(const std::map<std::string, int>& counts, double received_s) {
  for (const auto& [cause, times] : counts) {
    Oddity& oddity = oddities_[cause];
    if (times == oddity.times) continue;
    if (received_s - oddity.newest_s > options_.told_for_s) oddity.before = oddity.times;
    oddity.times = times;
    oddity.newest_s = received_s;
  }
}

bool StreamHealth::is_silent(const Stream& stream, double received_s) const {
  return stream.received_s &&
         received_s - *stream.received_s > std::max(options_.silent_after_s, kSilentIntervals * stream.interval_s);
}

void StreamHealth::judge(const Stream& stream, double received_s, std::vector<HealthFinding>& findings) const {
  const std::string name = stream.subject + ": ";
  if (!stream.received_s) {
    if (received_s - *begun_s_ > options_.missing_after_s)
      findings.push_back(
          {Level::bad, stream.subject,
           name + fmt::format("no {} has come yet, for {:.1f} s", stream.record, received_s - *begun_s_)});
    return;
  }
  if (is_silent(stream, received_s))
    findings.push_back({Level::bad, stream.subject,
                        name + fmt::format("no {} for {:.1f} s", stream.record, received_s - *stream.received_s)});
  if (stream.records > kKnown && stream.interval_s > kSlower * stream.usual_s && !is_silent(stream, received_s))
    findings.push_back(
        {Level::doubtful, stream.subject,
         name + fmt::format("{:.1f} records a second, {:.1f} before", 1 / stream.interval_s, 1 / stream.usual_s)});
  if (stream.age_s > options_.late_s)
    findings.push_back(
        {Level::doubtful, stream.subject, name + fmt::format("arrives {:.2f} s after its stamps", stream.age_s)});
  if (stream.age_s < -options_.early_s)
    findings.push_back(
        {Level::doubtful, stream.subject,
         name + fmt::format("stamps lie {:.2f} s in the future; do two computers' clocks differ?", -stream.age_s)});
}

/// Stamps of scans and of odometry that arrive at one time are compared: both clocks may differ from this one.
void StreamHealth::compare_clocks(const Stream& scans, std::vector<HealthFinding>& findings) const {
  if (std::min(scans.records, odometry_.records) < kFewRecords) return;
  const double later_s = scans.stamp_ahead_s - odometry_.stamp_ahead_s;
  if (!(std::abs(later_s) > options_.pairing.odometry_wait_s)) return;
  findings.push_back(
      {Level::bad, "clock",
       fmt::format("{}: scans are stamped {:.1f} s {} than odometry that arrives with them; are the clocks of "
                   "two computers apart?",
                   scans.subject, std::abs(later_s), later_s > 0 ? "later" : "earlier")});
}

std::vector<HealthFinding> StreamHealth::findings(double received_s) const {
  std::vector<HealthFinding> findings;
  if (!begun_s_) return findings;
  judge(odometry_, received_s, findings);
  for (const Stream& stream : scans_) judge(stream, received_s, findings);
  // One of several lasers may fail: the others go on.
  const auto is_well = [&](const Stream& stream) { return stream.received_s && !is_silent(stream, received_s); };
  if (std::any_of(scans_.begin(), scans_.end(), is_well))
    for (HealthFinding& finding : findings)
      if (finding.subject != odometry_.subject) finding.level = Level::doubtful;
  for (const Stream& stream : scans_) compare_clocks(stream, findings);
  for (const auto& [cause, oddity] : oddities_)
    if (received_s - oddity.newest_s <= options_.told_for_s)
      findings.push_back({Level::doubtful, subject_of(cause),
                          fmt::format("{}: {} times of late", cause, oddity.times - oddity.before)});
  return findings;
}

}  // namespace opal
