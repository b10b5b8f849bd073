#pragma once

#include <opal/sensing/log_source.hpp>
#include <opal/sensing/scan.hpp>

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace opal::ros2 {

/// Lasers whose first scan comes after localization has begun: whether they can join, and with what.
class LateLasers {
 public:
  /// What becomes of a scan.
  enum class Verdict {
    usual,         ///< its laser is known
    joins,         ///< the first one of a laser that is described: it fits, and is used from now on
    begins_anew,   ///< the first one of a laser whose geometry only its scans tell: a localizer has to be made with it
    does_not_fit,  ///< the first one of a laser that is not as described; the others are not used either
    is_left_out    ///< another one of such a laser
  };

  /// Localization begins. @param lasers  that it has. @param described  how many the robot has, as somebody says.
  /// @param records  that it begins with.
  void begin(std::vector<LaserModel> lasers, std::size_t described, std::span<const LogRecord> records);
  Verdict take(const LogRecord& record);
  /// No localizer can be made with the laser of this frame.
  void leave_out(const std::string& frame);
  /// One scan of each laser so far: what a localizer is made with.
  std::vector<LogRecord> first_scans() const { return first_scans_; }
  /// Why the newest one does not fit, in words.
  const std::string& objection() const { return objection_; }

 private:
  std::vector<LaserModel> lasers_;
  std::size_t described_ = 0;
  std::vector<LogRecord> first_scans_;
  std::set<std::string> heard_, left_out_;  // frames
  std::string objection_;
};

}  // namespace opal::ros2
