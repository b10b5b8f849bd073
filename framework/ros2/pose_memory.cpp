#include "ros2/pose_memory.hpp"

#include "common/text_file.hpp"
#include "common/whole_file.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iostream>
#include <utility>

namespace opal::ros2 {
namespace {

constexpr double kIntervalS = 2;

}  // namespace

PoseMemory::PoseMemory(std::string path, std::string map) : path_(std::move(path)), map_(std::move(map)) {
  if (path_.empty()) return;
  const WholeFile draft(path_);  // is thrown away
}

std::optional<Pose2> PoseMemory::recall() const {
  std::ifstream file(path_);
  if (path_.empty() || !file) return std::nullopt;
  try {
    const nlohmann::json kept = nlohmann::json::parse(file);
    const Pose2 pose(kept.at("x_m").get<double>(), kept.at("y_m").get<double>(), kept.at("heading_rad").get<double>());
    const bool is_here = kept.at("map") == map_ && pose.position().allFinite() && std::isfinite(pose.heading_rad());
    return is_here ? std::optional(pose) : std::nullopt;
  } catch (const nlohmann::json::exception& error) {
    std::cerr << path_ << ": no pose can be read, expected one that was kept: " << error.what() << '\n';
    return std::nullopt;
  }
}

void PoseMemory::keep(const Pose2& T_map_base, double now_s) {
  if (path_.empty() || now_s - kept_s_ < kIntervalS) return;
  kept_s_ = now_s;
  const nlohmann::ordered_json kept{
      {"map", map_}, {"x_m", T_map_base.x()}, {"y_m", T_map_base.y()}, {"heading_rad", T_map_base.heading_rad()}};
  try {
    write_text(path_, kept.dump(2) + '\n');
  } catch (const std::exception& error) {  // localization goes on without it
    std::cerr << error.what() << ": the pose is not kept any more\n";
    path_.clear();
  }
}

}  // namespace opal::ros2
