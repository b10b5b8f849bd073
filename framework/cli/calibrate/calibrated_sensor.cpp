#include "cli/calibrate/calibrated_sensor.hpp"
#include "deployment/mount_document.hpp"

namespace opal::cli {

std::string write_mount(nlohmann::ordered_json& document, const LaserModel& described, const LaserModel& used,
                        const nlohmann::ordered_json& mount) {
  nlohmann::ordered_json& sensors = document["sensor"];
  nlohmann::ordered_json& sensor = sensors.is_array() ? sensors.at(0) : sensors;
  if (described.geometry_from_log) {
    if (described.slice)
      return "geometry_from_log takes the mount of a slice from the log, with its height and tilt: correct it there";
    if (used.angle_increment_rad <= 0)
      return "the beams turn clockwise, and geometry_from_log, which takes such beams, takes the log's mount, too: "
             "correct it there";
    sensor["geometry_from_log"] = false;
    sensor["angle_min_rad"] = used.angle_min_rad;
    sensor["angle_increment_rad"] = used.angle_increment_rad;
    sensor["beams"] = used.beams;
    sensor["T_base_laser"] = mount_document(used.T_base_laser);
  }
  sensor["T_base_laser"].merge_patch(mount);
  return "";
}

}  // namespace opal::cli
