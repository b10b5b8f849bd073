#include "live/live_core.hpp"

#include <algorithm>

namespace opal {
namespace {

constexpr std::size_t kMostReceived = 1000;

}  // namespace

LiveCore::LiveCore(LocalizerParts parts, const LiveOptions& options, EventSink* events)
    : lasers_(parts.lasers),
      localizer_(std::move(parts), events),
      pairing_(lasers_, options.pairing),
      health_(lasers_, options) {}

void LiveCore::take(const LogRecord& record, double received_s, double now_s, const Listener& answer) {
  if (const auto* scan = std::get_if<RawScan>(&record)) {
    received_.push_back({scan->stamp_s, received_s});
    if (received_.size() > kMostReceived) received_.pop_front();
  }
  health_.take(record, received_s, now_s);
  pairing_.take(record);
  health_.note(pairing_.counts(), received_s);
  answer_all(received_s, answer);
}

void LiveCore::finish(const Listener& answer) {
  pairing_.finish();
  answer_all(received_.empty() ? 0 : received_.back().received_s, answer);
}

void LiveCore::answer_all(double received_s, const Listener& answer) {
  while (const std::optional<Sample> sample = pairing_.next()) answer(answer_to(*sample, received_s));
}

LiveAnswer LiveCore::answer_to(const Sample& sample, double received_s) {
  localizer_.update(sample);
  LiveAnswer answer;
  answer.number = ++answers_;
  answer.stamp_s = sample.stamp_s;
  answer.estimate = localizer_.estimate_at(sample.stamp_s, sample.T_odom_base);
  answer.T_map_odom = answer.estimate.T_map_base * sample.T_odom_recorded.inverse();
  answer.why = localizer_.why();
  answer.health = health(received_s);
  answer.waited_s = answer.latency_s = waited_since(sample.stamp_s, received_s);
  return answer;
}

/// How long ago the scan came, and forgets it with those before.
double LiveCore::waited_since(double stamp_s, double received_s) {
  const auto found = std::ranges::find_if(received_, [&](const Received& scan) { return scan.stamp_s == stamp_s; });
  if (found == received_.end()) return 0;
  const double waited_s = received_s - found->received_s;
  received_.erase(received_.begin(), found + 1);
  return waited_s;
}

std::vector<HealthFinding> LiveCore::health(double received_s) const {
  std::vector<HealthFinding> findings = health_.findings(received_s);
  for (const SensorFinding& finding : localizer_.sensor_findings()) {
    if (finding.verdict == SensorFinding::Verdict::fine) continue;
    const bool is_wrong = finding.verdict == SensorFinding::Verdict::contradicted;
    findings.push_back(
        {is_wrong ? HealthFinding::Level::bad : HealthFinding::Level::doubtful, "sensor description", finding.words});
  }
  if (const std::string doubt = localizer_.map_doubt(); !doubt.empty())
    findings.push_back({HealthFinding::Level::doubtful, "map", doubt});
  return findings;
}

}  // namespace opal
