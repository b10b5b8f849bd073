#include <opal/ground_truth.hpp>

#include <opal/error.hpp>

#include <cstdio>
#include <fstream>

namespace opal {

GroundTruth GroundTruth::read(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw LogError(path + ": cannot be read");
  GroundTruth truth;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (number == 1 || line.empty()) continue;  // the header
    double stamp = 0, x = 0, y = 0, heading = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &stamp, &x, &y, &heading) != 4)
      throw LogError(path + ": line " + std::to_string(number) + ": '" + line +
                     "', expected timestamp,x,y,theta,is_scan");
    if (truth.poses_.empty() || stamp > truth.poses_.back().stamp_s)
      truth.poses_.push_back({stamp, {x, y, heading}});
    else
      truth.poses_.back().pose = {x, y, heading};  // the scan's own pose follows and wins
  }
  return truth;
}

std::optional<Pose2> GroundTruth::T_map_laser_at(double stamp_s) const { return pose_at(poses_, stamp_s); }

}  // namespace opal
