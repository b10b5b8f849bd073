#pragma once

#include <opal/live/live_localizer.hpp>
#include <opal/recording/recording.hpp>

#include <iosfwd>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace opal::ros2 {

/// What a person is told of a node's health, line by line: what changes when it changes, complaints every five seconds.
class HealthReport {
 public:
  /// @param out  must outlive it. @param started_s  by the steady clock of all calls: others may take two seconds to be
  /// found before their absence is told.
  HealthReport(std::ostream& out, double started_s);

  /// A new status, with the pose or the reason.
  void status(const LiveAnswer& answer);
  /// Each kind of them once: how often is in the diagnostics.
  void defects(const recording::Defects& defects);
  /// What does not match now; none: all is well.
  void complaints(const std::vector<std::string>& words, double now_s);

 private:
  std::ostream& out_;
  double complained_s_;
  std::optional<Status> status_;
  std::set<std::string> defects_;
  std::string complained_;
};

}  // namespace opal::ros2
