#pragma once

#include "live/stream_health.hpp"

#include <opal/live/live_localizer.hpp>

#include <deque>
#include <functional>

namespace opal {

/// What a live localizer does with each record, without a thread: the same records give the same answers.
class OPAL_EXPORT LiveCore {
 public:
  using Listener = std::function<void(LiveAnswer)>;

  LiveCore(LocalizerParts parts, const LiveOptions& options, EventSink* events);

  /// @param received_s  by a clock that never jumps. @param now_s  by the clock of the stamps; NaN: not known.
  void take(const LogRecord& record, double received_s, double now_s, const Listener& answer);
  /// No more records will come.
  void finish(const Listener& answer);

  std::vector<HealthFinding> health(double received_s) const;
  const std::map<std::string, int>& counts() const { return pairing_.counts(); }

 private:
  struct Received {
    double stamp_s;
    double received_s;
  };

  void answer_all(double received_s, const Listener& answer);
  LiveAnswer answer_to(const Sample& sample, double received_s);
  double waited_since(double stamp_s, double received_s);

  std::vector<LaserModel> lasers_;
  Localizer localizer_;
  ScanPairing pairing_;
  StreamHealth health_;
  std::deque<Received> received_;  ///< of scans that have not been answered
  std::uint64_t answers_ = 0;
};

}  // namespace opal
