#include "evaluation/ground_truth.hpp"

#include <opal/common/error.hpp>
#include <opal/common/number_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace opal {
namespace {

std::string without_blanks(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  return text;
}

void expect_header(const std::string& line, const std::string& path) {
  if (!line.starts_with("timestamp,x,y,theta"))
    throw LogError(path + ": line 1: '" + line + "', expected the header timestamp,x,y,theta,is_scan");
}

/// The first four fields, if they are finite numbers.
std::optional<StampedPose> pose_in(const std::string& line) {
  std::array<double, 4> fields{};
  std::size_t begin = 0;
  for (double& field : fields) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const auto value =
        begin > line.size() ? std::nullopt : parse_number<double>(without_blanks(line.substr(begin, end - begin)));
    if (!value || !std::isfinite(*value)) return std::nullopt;
    field = *value;
    begin = end + 1;
  }
  return StampedPose{fields[0], {fields[1], fields[2], fields[3]}};
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
    const auto stamped = pose_in(line);
    if (!stamped)
      throw LogError(fmt::format("{}: line {}: '{}', expected timestamp,x,y,theta,is_scan", path, number, line));
    if (poses.empty() || stamped->stamp_s > poses.back().stamp_s)
      poses.push_back(*stamped);
    else
      poses.back().pose = stamped->pose;  // the scan's own pose follows and wins
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
