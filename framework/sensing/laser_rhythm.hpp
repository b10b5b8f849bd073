#pragma once

#include <limits>

namespace opal {

/// When one laser scans: what is known of its next scan.
class LaserRhythm {
 public:
  /// The stamp of its newest scan.
  void scanned(double stamp_s);
  /// A new timeline.
  void restart() { last_s_ = kNever; }

  /// Usual time between two scans.
  double interval_s() const { return interval_s_; }
  /// Time between two scans on average of late; 0 before there are some.
  double mean_interval_s() const { return intervals_ < kFewIntervals ? 0 : mean_interval_s_; }
  /// Whether a scan of it that begins until `stamp_s` is to be expected. @param now_s  the newest stamp of anything.
  bool is_due_until(double stamp_s, double now_s) const;

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  double last_s_ = kNever;
  double before_s_ = 0;  ///< time between the two scans before the newest one
  double interval_s_ = 0.1;
  static constexpr int kFewIntervals = 5;
  int intervals_ = 0;
  double mean_interval_s_ = 0;
};

}  // namespace opal
