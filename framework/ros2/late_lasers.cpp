#include "ros2/late_lasers.hpp"

#include <opal/common/error.hpp>
#include "sensing/log_check.hpp"

#include <algorithm>

namespace opal::ros2 {

void LateLasers::begin(std::vector<LaserModel> lasers, std::size_t described, std::span<const LogRecord> records) {
  lasers_ = std::move(lasers);
  described_ = described;
  for (const LogRecord& record : records)
    if (const auto* scan = std::get_if<RawScan>(&record); scan && heard_.insert(scan->frame).second)
      first_scans_.push_back(record);
}

void LateLasers::leave_out(const std::string& frame) {
  left_out_.insert(frame);
  std::erase_if(first_scans_, [&](const LogRecord& record) { return std::get<RawScan>(record).frame == frame; });
}

LateLasers::Verdict LateLasers::take(const LogRecord& record) {
  const auto* scan = std::get_if<RawScan>(&record);
  if (!scan) return Verdict::usual;
  if (left_out_.contains(scan->frame)) return Verdict::is_left_out;
  if (!heard_.insert(scan->frame).second) return Verdict::usual;
  const auto laser = std::ranges::find_if(lasers_, [&](const LaserModel& each) { return each.frame == scan->frame; });
  if (laser == lasers_.end() && lasers_.size() >= described_) return Verdict::usual;
  first_scans_.push_back(record);
  if (laser == lasers_.end()) return Verdict::begins_anew;
  try {
    check_log({&record, 1}, *laser, "the robot", "laser " + scan->frame);
  } catch (const ConfigError& error) {
    objection_ = error.what();
    leave_out(scan->frame);
    return Verdict::does_not_fit;
  }
  return Verdict::joins;
}

}  // namespace opal::ros2
