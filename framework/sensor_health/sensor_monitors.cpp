#include "sensor_health/sensor_monitors.hpp"

#include <algorithm>

namespace opal {
namespace {

bool says_odometry_stands(const SensorFinding& finding) {
  return finding.subject == SensorFinding::Subject::standing_odometry &&
         finding.verdict == SensorFinding::Verdict::contradicted;
}

}  // namespace

SensorMonitors::SensorMonitors(const std::vector<LaserModel>& lasers, const std::shared_ptr<const ScanMatcher>& matcher)
    : lasers_(lasers) {
  for (const LaserModel& laser : lasers) monitors_.emplace_back(laser, matcher);
}

bool SensorMonitors::add(const Sample& sample) {
  bool changed = false;
  for (const LaserView& view : sample.views) {
    const auto laser = static_cast<std::size_t>(view.laser);
    if (laser >= monitors_.size()) continue;
    // Odometry at the scan's own stamp.
    const bool is_mount = distance_m(view.T_base_laser, lasers_[laser].T_base_laser) == 0 &&
                          angle_between_rad(view.T_base_laser, lasers_[laser].T_base_laser) == 0;
    const Pose2 T_odom_base =
        is_mount ? sample.T_odom_base : sample.T_odom_base * view.T_base_laser * lasers_[laser].T_base_laser.inverse();
    changed = monitors_[laser].add(view.scan, T_odom_base) || changed;
  }
  return changed;
}

const std::vector<SensorFinding>& SensorMonitors::findings() const {
  findings_.clear();
  for (std::size_t k = 0; k < monitors_.size(); ++k)
    for (SensorFinding finding : monitors_[k].findings()) {
      if (monitors_.size() > 1) finding.words = "laser " + name_of(lasers_[k], k) + ": " + finding.words;
      findings_.push_back(std::move(finding));
    }
  if (auto slip = slip_.finding()) findings_.push_back(std::move(*slip));
  return findings_;
}

void SensorMonitors::clear() {
  for (SensorMonitor& monitor : monitors_) monitor.clear();
  slip_.clear();
  findings_.clear();
}

bool SensorMonitors::is_odometry_frozen() const {
  return std::ranges::any_of(monitors_, [](const SensorMonitor& monitor) {
    return std::ranges::any_of(monitor.findings(), says_odometry_stands);
  });
}

bool SensorMonitors::only_odometry_stands() const {
  return is_odometry_frozen() && std::ranges::all_of(findings(), [](const SensorFinding& finding) {
           return finding.verdict != SensorFinding::Verdict::contradicted || says_odometry_stands(finding);
         });
}

std::string SensorMonitors::contradiction() const {
  for (const SensorFinding& finding : findings())
    if (finding.verdict == SensorFinding::Verdict::contradicted) return finding.words;
  return "";
}

}  // namespace opal
