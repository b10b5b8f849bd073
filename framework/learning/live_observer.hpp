#pragma once

#include "learning/drive_evidence.hpp"

#include <opal/sensing/log_source.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace opal {

/// Learns while the robot drives, in a thread of its own: whoever gives records waits for nobody. Memory is bounded.
class LiveObserver {
 public:
  /// Gets what each visit says as soon as it has ended, from the thread of the observer.
  using Listener = std::function<void(const DriveEvidence&)>;

  /// @param parts  of a localizer with a map; this one localizes by itself.
  /// @param drive  name of the drive; visits are named "DRIVE, visit 1", ...
  /// @param most_queued  records; when one more comes, the oldest one is dropped.
  LiveObserver(const LocalizerParts& parts, std::string drive, Listener heard, std::size_t most_queued = 2000);
  /// Ends the visit, tells it, and waits for the thread. Records that still wait are left out.
  ~LiveObserver();
  LiveObserver(const LiveObserver&) = delete;
  LiveObserver& operator=(const LiveObserver&) = delete;

  /// In the order in which records arrive.
  void take(LogRecord record);
  /// Waits until all records that were taken so far have been worked on. @return false if the time is up.
  bool drain(double timeout_s);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace opal
