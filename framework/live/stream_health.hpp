#pragma once

#include <opal/live/health.hpp>
#include <opal/live/live_localizer.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// Watches records as they arrive: who is silent or was never heard, whose stamps cannot be true, and what was odd.
class OPAL_EXPORT StreamHealth {
 public:
  StreamHealth(const std::vector<LaserModel>& lasers, const LiveOptions& options);

  /// @param received_s  by a clock that never jumps. @param now_s  by the clock of the stamps; NaN: not known.
  void take(const LogRecord& record, double received_s, double now_s);
  /// What the pairing has counted so far; what has grown is told for a while.
  void note(const std::map<std::string, int>& counts, double received_s);
  /// What is not fine.
  std::vector<HealthFinding> findings(double received_s) const;

 private:
  /// One sensor's records.
  struct Stream {
    std::string subject;  ///< "odometry", "laser front"
    std::string record;   ///< "odometry", "scan"
    std::optional<double> received_s = {};
    double interval_s = 0;  ///< between arrivals, on average of late
    double usual_s = 0;     ///< the same over a longer time
    int records = 0;
    double age_s = 0;          ///< of stamps on arrival, on average
    double stamp_ahead_s = 0;  ///< of the clock of arrival, by the records that were delayed least of late
  };
  struct Oddity {
    int times = 0;        ///< in all
    int before = 0;       ///< when it began to be told
    double newest_s = 0;  ///< arrival of the newest
  };

  Stream* stream_of(const LogRecord& record);
  static void hear(Stream& stream, double received_s, double stamp_s, double now_s);
  void judge(const Stream& stream, double received_s, std::vector<HealthFinding>& findings) const;
  void compare_clocks(const Stream& scans, std::vector<HealthFinding>& findings) const;
  bool is_silent(const Stream& stream, double received_s) const;

  LiveOptions options_;
  std::vector<LaserModel> lasers_;
  Stream odometry_{"odometry", "odometry"};
  std::vector<Stream> scans_;  ///< by laser
  std::map<std::string, Oddity> oddities_;
  std::optional<double> begun_s_;
};

}  // namespace opal
