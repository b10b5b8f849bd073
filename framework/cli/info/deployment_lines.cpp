#include "cli/info/deployment_lines.hpp"

#include "common/text_file.hpp"
#include "session/moved_deployment.hpp"
#include "session/shipped_files.hpp"

#include <opal/deployment/deployment.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>

namespace opal::cli {
namespace {

/// Logs hold single precision: more digits would only look like knowledge.
double rounded(double value, double unit) {
  const double per_unit = std::round(1 / unit);  // a division by a whole number gives the shortest text
  return std::round(value * per_unit) / per_unit + 0.0;
}

constexpr double kMillimetre = 1e-3;
constexpr double kMicroradian = 1e-6;
constexpr double kNanoradian = 1e-9;  // of an increment, which a thousand beams add up

const LogLaser* laser_that_is_read(const LogContents& contents) {
  for (const LogLaser& laser : contents.lasers)
    if (laser.is_read) return &laser;
  return nullptr;
}

/// Logs of CARMEN state no angles: their lasers look half a turn to the front, from right to left.
bool takes_half_a_turn(const LogLaser& laser) {
  return !laser.angle_min_rad && laser.beams > 1 && laser.farthest_m > 0;  // one that sees nothing tells nothing
}

void add_half_a_turn(nlohmann::ordered_json& sensor, int beams) {
  const int gaps = beams % 2 == 0 ? beams : beams - 1;  // 180 and 181 beams are one degree apart
  sensor["angle_min_rad"] = rounded(-std::numbers::pi / 2, kMicroradian);
  sensor["angle_increment_rad"] = rounded(std::numbers::pi / gaps, kNanoradian);
  sensor["beams"] = beams;
}

/// A description has beams that turn counter-clockwise; of others only the log can tell.
void add_beams(nlohmann::ordered_json& sensor, const LogLaser& laser) {
  if (takes_half_a_turn(laser)) return add_half_a_turn(sensor, laser.beams);
  if (!laser.angle_min_rad || !laser.angle_increment_rad) return;
  const double sense = laser.mount && laser.mount->upside_down ? -1 : 1;
  const double increment_rad = sense * *laser.angle_increment_rad;
  if (increment_rad <= 0 || laser.beams == 0) return;
  sensor["angle_min_rad"] = rounded(sense * *laser.angle_min_rad, kMicroradian);
  sensor["angle_increment_rad"] = rounded(increment_rad, kNanoradian);
  sensor["beams"] = laser.beams;
}

/// A range that stands for "nothing" lies above the farthest one that counts.
void add_ranges(nlohmann::ordered_json& sensor, const LogLaser& laser) {
  constexpr double kMostRange_m = 999;
  const bool is_stated = laser.range_max_m > laser.range_min_m && laser.range_max_m <= kMostRange_m;
  if (is_stated && laser.range_min_m >= 0) sensor["range_min_m"] = rounded(laser.range_min_m, kMillimetre);
  if (laser.no_return_m > 0 && laser.farthest_m < laser.no_return_m) {
    sensor["range_max_m"] = rounded(std::min(kMostRange_m, (laser.farthest_m + laser.no_return_m) / 2), kMillimetre);
    sensor["no_return_m"] = rounded(laser.no_return_m, kMillimetre);
  } else if (is_stated) {
    sensor["range_max_m"] = rounded(laser.range_max_m, kMillimetre);
  }
}

void add_mount(nlohmann::ordered_json& sensor, const std::optional<LogMount>& mount) {
  if (!mount) return;
  const Pose2& T_base_laser = mount->T_base_laser;
  sensor["T_base_laser"] = {{"x_m", rounded(T_base_laser.x(), kMillimetre)},
                            {"y_m", rounded(T_base_laser.y(), kMillimetre)},
                            {"heading_rad", rounded(T_base_laser.heading_rad(), kMicroradian)}};
}

nlohmann::ordered_json laser_sensor(const LogLaser& laser) {
  nlohmann::ordered_json sensor = nlohmann::ordered_json::object();
  add_beams(sensor, laser);
  add_ranges(sensor, laser);
  add_mount(sensor, laser.mount);
  if (laser.angle_min_rad) sensor["geometry_from_log"] = true;
  return sensor;
}

/// A slice of point clouds, all around in steps of half a degree.
nlohmann::ordered_json sliced_sensor(const LogCloud& cloud) {
  constexpr double kCentimetre_m = 1e-2, kLeastRange_m = 30, kMostRange_m = 100;
  constexpr int kBeams = 720;
  nlohmann::ordered_json sensor{{"topic", cloud.topic}, {"frame", cloud.frame}};
  sensor["angle_min_rad"] = rounded(-std::numbers::pi, kMicroradian);
  sensor["angle_increment_rad"] = rounded(2 * std::numbers::pi / kBeams, kNanoradian);
  sensor["beams"] = kBeams;
  sensor["range_max_m"] = std::clamp(std::ceil(cloud.farthest_m), kLeastRange_m, kMostRange_m);
  sensor["slice"] = {{"z_min_m", rounded(cloud.suggested->z_min_m, kCentimetre_m)},
                     {"z_max_m", rounded(cloud.suggested->z_max_m, kCentimetre_m)}};
  add_mount(sensor, cloud.mount);
  if (cloud.mount) sensor["geometry_from_log"] = true;
  return sensor;
}

/// Where no planar laser is read, a slice of the first 3D lidar; null if there is neither.
nlohmann::ordered_json sensor_of(const LogContents& contents) {
  if (const LogLaser* laser = laser_that_is_read(contents)) return laser_sensor(*laser);
  for (const LogCloud& cloud : contents.clouds)
    if (cloud.suggested) return sliced_sensor(cloud);
  return nullptr;
}

}  // namespace

nlohmann::ordered_json deployment_lines(const LogContents& contents, const std::string& source) {
  nlohmann::ordered_json lines;
  const nlohmann::ordered_json sensor = sensor_of(contents);
  if (sensor.is_null()) return lines;
  if (!sensor.empty()) lines["sensor"] = sensor;
  if (contents.options.empty()) return lines;
  nlohmann::ordered_json options;
  for (const auto& [name, value] : contents.options) options[name] = value;
  lines["log_sources"] = nlohmann::ordered_json::array({{{"@type", source}, {"options", options}}});
  return lines;
}

std::string doubt_of_lines(const LogContents& contents) {
  const LogLaser* laser = laser_that_is_read(contents);
  if (laser == nullptr || !takes_half_a_turn(*laser)) return "";
  return fmt::format(
      "the log does not state the angles of its {} beams; half a turn to the front is taken: correct "
      "angle_min_rad and angle_increment_rad if the laser is another one",
      laser->beams);
}

void write_deployment(const nlohmann::ordered_json& lines, const std::string& config, const std::string& out) {
  const std::string start = session::config_file(config);
  read_deployment(start);  // what is wrong with it is told here
  auto document = nlohmann::ordered_json::parse(std::ifstream(start));
  document.erase("comment");
  document.merge_patch(lines);
  write_text(out, session::moved_deployment(std::move(document), start, out).dump(2) + '\n');
  std::cerr << "written: " << out << '\n';
}

}  // namespace opal::cli
