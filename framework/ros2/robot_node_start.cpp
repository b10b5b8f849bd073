#include "ros2/robot_node.hpp"

#include <opal/common/error.hpp>

#include <iostream>
#include <limits>

namespace opal::ros2 {
namespace {

// How far a robot may have been moved while the program was off, one sigma.
constexpr double kMemorySigmaM = 0.5, kMemorySigmaRad = 0.3;

}  // namespace

void RobotNode::begin() {
  const OdomFrame odom = odom_frame_of(options_.frames.odom, options_.is_odom_frame_stated, stream_.odom_frame());
  if (!odom.words.empty()) std::cerr << "ros2: " << odom.words << '\n';
  if (odom.frame != options_.read.odom_frame) fell_back_ = false;  // transforms of another frame are no odometry here
  options_.frames.odom = options_.read.odom_frame = odom.frame;
  make_localizer(before_);
  if (const auto pose = memory_.recall()) {
    live_->hint({*pose, kMemorySigmaM, kMemorySigmaRad});
    std::cerr << "ros2: the pose of the last run is taken as a hint\n";
  }
  for (LogRecord& record : before_) localize(std::move(record), std::numeric_limits<double>::quiet_NaN());
  before_.clear();
  start_announcing();
  std::cerr << "ros2: localizing\n";
}

void RobotNode::start_announcing() {
  announcer_ = std::jthread([this](const std::stop_token& stop) { announce(stop); });
}

/// With the lasers that these records have scans of.
void RobotNode::make_localizer(std::vector<LogRecord> records) {
  const std::vector<MountRecord>& mounts = stream_.mounts();
  records.insert(records.begin(), mounts.begin(), mounts.end());
  std::optional<AliveMeanwhile> alive;  // a large map takes longer than a watchdog waits
  if (notice_ != nullptr) alive.emplace(*notice_);
  LocalizerParts parts = make_parts_(records);
  late_lasers_.begin(parts.lasers, recording::scan_topics_of(options_.read).size(), records);
  live_ = std::make_unique<LiveLocalizer>(std::move(parts), LiveOptions{}, events_);
}

/// The localizer does not know the laser of this frame, and there is a scan of it now.
bool RobotNode::begin_anew_with(const std::string& frame) {
  const LiveAnswer last = newest();
  announcer_ = {};
  live_.reset();  // what it says is complete before another one begins
  bool is_used = true;
  try {
    make_localizer(late_lasers_.first_scans());
    std::cerr << "ros2: scans of " << frame << " have come: localization begins anew with this laser\n";
  } catch (const Error& error) {
    std::cerr << "ros2: " << error.what() << ": localization begins anew without the laser " << frame << '\n';
    is_used = false;
    late_lasers_.leave_out(frame);
    make_localizer(late_lasers_.first_scans());
  }
  if (last.estimate.status == Status::localized)
    live_->hint({last.estimate.T_map_base, kMemorySigmaM, kMemorySigmaRad});
  start_announcing();
  return is_used;
}

/// Whether it is localized with this record.
bool RobotNode::may_use(const LogRecord& record) {
  using Verdict = LateLasers::Verdict;
  const auto frame = [&] { return std::get<RawScan>(record).frame; };
  switch (late_lasers_.take(record)) {
    case Verdict::usual: return true;
    case Verdict::is_left_out: return false;
    case Verdict::begins_anew: return begin_anew_with(frame());
    case Verdict::joins:
      std::cerr << "ros2: scans of " << frame() << " have come: this laser is used, too\n";
      return true;
    case Verdict::does_not_fit:
      std::cerr << "ros2: " << late_lasers_.objection() << ": its scans are left out\n";
      return false;
  }
  return true;
}

void RobotNode::localize(LogRecord record, double now_s) {
  if (!may_use(record)) return;
  if (heard_) heard_(record);
  live_->take(std::move(record), now_s);
}

}  // namespace opal::ros2
