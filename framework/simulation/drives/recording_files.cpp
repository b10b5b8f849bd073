#include "simulation/drives/recording.hpp"

#include "common/text_file.hpp"
#include "common/whole_file.hpp"
#include "common/write_error.hpp"
#include "map/map_file.hpp"
#include "map_tools/map_raster.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace opal::simulation {
namespace {

std::string pose_words(const Pose2& pose) {
  return fmt::format("{:.6f} {:.6f} {:.6f}", pose.x(), pose.y(), pose.heading_rad());
}

std::string when_text(double stamp_s) { return fmt::format("{0:.4f} nohost {0:.4f}\n", stamp_s); }

std::string line_of(const OdometryRecord& odometry) {
  return "ODOM " + pose_words(odometry.T_odom_base) + " 0 0 0 " + when_text(odometry.stamp_s);
}

std::string line_of(const RawScan& scan) {
  const std::string odometry = pose_words(scan.T_odom_base.value_or(Pose2()));
  const std::string message = scan.frame.empty() ? "FLASER" : scan.frame;
  std::string line = message + " " + std::to_string(scan.ranges_m.size());
  for (float range : scan.ranges_m) line += fmt::format(" {:.3f}", static_cast<double>(range));
  return line + " " + odometry + " " + odometry + " " + when_text(scan.stamp_s);
}

std::string line_of(const MountRecord&) { return ""; }
std::string line_of(const HintRecord&) { return ""; }
std::string line_of(const ForgetRecord&) { return ""; }

std::vector<std::string> lines_of(const Recording& recording) {
  std::vector<std::string> lines;
  for (const LogRecord& record : records_of(recording))
    lines.push_back(std::visit([](const auto& kind) { return line_of(kind); }, record));
  return lines;
}

void write_log(const Recording& recording, const std::string& path) {
  WholeFile whole(path);
  errno = 0;
  const gzFile file = gzdopen(dup(whole.descriptor()), "wb6");
  bool good = file != nullptr;
  for (const std::string& line : lines_of(recording)) {
    if (!good) break;
    good = gzwrite(file, line.data(), static_cast<unsigned>(line.size())) == static_cast<int>(line.size());
  }
  if (file != nullptr && gzclose(file) != Z_OK) good = false;
  if (!good) throw WriteError(path, errno);
  whole.finish();
}

std::string truth_of(const Recording& recording) {
  std::string text = "timestamp,x,y,theta,is_scan\n";
  for (const RecordedScan& recorded : recording.scans) {
    const Pose2 pose = recorded.T_map_base * recording.laser.T_base_laser;
    text +=
        fmt::format("{:.4f},{:.4f},{:.4f},{:.5f},1\n", recorded.scan.stamp_s, pose.x(), pose.y(), pose.heading_rad());
  }
  return text;
}

nlohmann::ordered_json laser_of(const LaserModel& laser) {
  constexpr double kDegree_rad = radians(1);
  nlohmann::ordered_json described = {{"n_beams", laser.beams},
                                      {"angle_min_deg", laser.angle_min_rad / kDegree_rad},
                                      {"angle_increment_deg", laser.angle_increment_rad / kDegree_rad},
                                      {"range_max_m", laser.range_max_m},
                                      {"no_return_at_or_above_m", laser.no_return_m},
                                      {"offset_x_m", laser.T_base_laser.x()},
                                      {"offset_y_m", laser.T_base_laser.y()},
                                      {"offset_theta", laser.T_base_laser.heading_rad()}};
  if (laser.sweep_s) described["sweep_s"] = *laser.sweep_s;
  return described;
}

nlohmann::ordered_json info_of(const Recording& recording, const std::string& name) {
  return {{"site", name},
          {"laser", laser_of(recording.laser)},
          {"time", "simulated (start = 0)"},
          {"n_scans", recording.scans.size()},
          {"ground_truth", "simulated"}};
}

nlohmann::ordered_json queries_of(const Recording& recording, const std::string& name) {
  nlohmann::ordered_json queries = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < recording.queries.size(); ++k) {
    const Query& query = recording.queries[k];
    queries.push_back({{"id", name + "-" + query.id},
                       {"start_time", query.start_s},
                       {"end_time", query.end_s},
                       {"distance_m", recording.distances_m[k]},
                       {"duration_s", query.end_s - query.start_s},
                       {"map_overlap", 0.0}});
  }
  return {{"site", name}, {"honest_split", true}, {"note", "simulated"}, {"queries", queries}};
}

}  // namespace

void write_recording(const Recording& recording, const std::string& prefix, const std::string& name) {
  write_log(recording, prefix + ".log.gz");
  write_text(prefix + ".gt.csv", truth_of(recording));
  write_text(prefix + ".info.json", info_of(recording, name).dump(1) + '\n');
  write_text(prefix + ".queries.json", queries_of(recording, name).dump(1) + '\n');
}

void write_recording(const Recording& recording, const std::string& prefix) {
  write_recording(recording, prefix, std::filesystem::path(prefix).filename().string());
}

void write_recorded_place(const Recording& recording, const SemanticMap& map, const std::string& prefix) {
  const std::filesystem::path path(prefix);
  if (path.has_parent_path()) make_folder(path.parent_path().string());
  write_recording(recording, prefix);
  write_map(map, prefix + ".map.jsonld");
  write_raster(rasterized(map), prefix + ".map.yaml");
}

}  // namespace opal::simulation
