#include "evaluation/ground_truth.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace opal {
namespace {

void expect_header(const std::string& line, const std::string& path) {
  if (!line.starts_with("timestamp,x,y,theta"))
    throw LogError(path + ": line 1: '" + line + "', expected the header timestamp,x,y,theta,is_scan");
}

}  // namespace

GroundTruth GroundTruth::read(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw LogError(path + ": cannot be read: " + std::strerror(errno) + ", expected recorded truth (.gt.csv)");
  std::vector<StampedPose> poses;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (number == 1) expect_header(line, path);
    if (number == 1 || line.empty()) continue;
    double stamp = 0, x = 0, y = 0, heading = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &stamp, &x, &y, &heading) != 4)
      throw LogError(fmt::format("{}: line {}: '{}', expected timestamp,x,y,theta,is_scan", path, number, line));
    if (poses.empty() || stamp > poses.back().stamp_s)
      poses.push_back({stamp, {x, y, heading}});
    else
      poses.back().pose = {x, y, heading};  // the scan's own pose follows and wins
  }
  if (poses.empty()) throw LogError(path + ": holds no pose, expected lines of timestamp,x,y,theta,is_scan");
  return GroundTruth(std::move(poses));
}

GroundTruth::GroundTruth(std::vector<StampedPose> T_map_laser) : poses_(std::move(T_map_laser)) {
  for (std::size_t k = 0; k < poses_.size(); ++k)
    driven_m_.push_back(k == 0 ? 0 : driven_m_.back() + distance_m(poses_[k - 1].pose, poses_[k].pose));
}

std::optional<Pose2> GroundTruth::T_map_laser_at(double stamp_s) const { return pose_at(poses_, stamp_s); }

double GroundTruth::driven_m(double stamp_s) const {
  const auto after = std::ranges::lower_bound(poses_, stamp_s, {}, &StampedPose::stamp_s);
  if (after == poses_.begin()) return 0;
  if (after == poses_.end()) return driven_m_.back();
  const std::size_t k = static_cast<std::size_t>(after - poses_.begin());
  const double share = (stamp_s - poses_[k - 1].stamp_s) / (poses_[k].stamp_s - poses_[k - 1].stamp_s);
  return driven_m_[k - 1] + share * (driven_m_[k] - driven_m_[k - 1]);
}

}  // namespace opal
