#include "cli/info/contents_text.hpp"

namespace opal::cli {
namespace {

using Json = nlohmann::ordered_json;

Json topics_json(const LogContents& contents) {
  Json topics = Json::array();
  for (const LogTopic& topic : contents.topics)
    topics.push_back({{"name", topic.name},
                      {"type", topic.type},
                      {"messages", topic.messages},
                      {"first_s", topic.first_s},
                      {"last_s", topic.last_s},
                      {"interval_s", topic.interval_s},
                      {"gaps", topic.gaps},
                      {"longest_gap_s", topic.longest_gap_s},
                      {"longest_gap_at_s", topic.longest_gap_at_s}});
  return topics;
}

Json mount_json(const LogMount& mount) {
  return {{"parent", mount.parent},           {"x_m", mount.T_base_laser.x()},
          {"y_m", mount.T_base_laser.y()},    {"heading_rad", mount.T_base_laser.heading_rad()},
          {"height_m", mount.height_m},       {"tilt_rad", mount.tilt_rad},
          {"upside_down", mount.upside_down}, {"from_moving_topic", mount.from_moving_topic}};
}

Json laser_json(const LogLaser& laser) {
  Json json{{"topic", laser.topic},
            {"frame", laser.frame},
            {"is_read", laser.is_read},
            {"scans", laser.scans},
            {"beams", laser.beams},
            {"other_scans", laser.other_scans},
            {"range_min_m", laser.range_min_m},
            {"range_max_m", laser.range_max_m},
            {"sweep_s", laser.sweep_s},
            {"nearest_m", laser.nearest_m},
            {"farthest_m", laser.farthest_m},
            {"no_return_share", laser.no_return_share},
            {"invalid_share", laser.invalid_share},
            {"no_return_m", laser.no_return_m},
            {"recorded_after_s", laser.recorded_after_s}};
  if (laser.angle_min_rad) json["angle_min_rad"] = *laser.angle_min_rad;
  if (laser.angle_increment_rad) json["angle_increment_rad"] = *laser.angle_increment_rad;
  if (laser.mount) json["mount"] = mount_json(*laser.mount);
  return json;
}

Json cloud_json(const LogCloud& cloud) {
  Json json{{"topic", cloud.topic},
            {"frame", cloud.frame},
            {"clouds", cloud.clouds},
            {"width", cloud.width},
            {"height", cloud.height},
            {"fields", cloud.fields},
            {"valid_share", cloud.valid_share},
            {"time_field", cloud.time_field},
            {"sweep_s", cloud.sweep_s},
            {"x_m", {cloud.x_min_m, cloud.x_max_m}},
            {"y_m", {cloud.y_min_m, cloud.y_max_m}},
            {"z_m", {cloud.z_min_m, cloud.z_max_m}},
            {"farthest_m", cloud.farthest_m}};
  if (cloud.mount) json["mount"] = mount_json(*cloud.mount);
  if (cloud.suggested)
    json["suggested"] = {{"z_min_m", cloud.suggested->z_min_m}, {"z_max_m", cloud.suggested->z_max_m}};
  return json;
}

Json odometry_json(const LogOdometry& odometry) {
  return {{"topic", odometry.topic},           {"odom_frame", odometry.odom_frame},
          {"base_frame", odometry.base_frame}, {"is_read", odometry.is_read},
          {"poses", odometry.poses},           {"driven_m", odometry.driven_m},
          {"turned_rad", odometry.turned_rad}, {"recorded_after_s", odometry.recorded_after_s}};
}

Json transform_json(const LogTransform& transform) {
  return {{"parent", transform.parent},     {"child", transform.child},         {"topic", transform.topic},
          {"messages", transform.messages}, {"is_static", transform.is_static}, {"moves", transform.moves}};
}

}  // namespace

Json contents_json(const LogContents& contents) {
  Json json{{"format", contents.format},
            {"first_s", contents.first_s},
            {"last_s", contents.last_s},
            {"looked_at_s", contents.looked_at_s},
            {"topics", topics_json(contents)}};
  json["lasers"] = json["clouds"] = json["odometries"] = json["transforms"] = Json::array();
  for (const LogLaser& laser : contents.lasers) json["lasers"].push_back(laser_json(laser));
  for (const LogCloud& cloud : contents.clouds) json["clouds"].push_back(cloud_json(cloud));
  for (const LogOdometry& odometry : contents.odometries) json["odometries"].push_back(odometry_json(odometry));
  for (const LogTransform& transform : contents.transforms) json["transforms"].push_back(transform_json(transform));
  json["defects"] = Json::object();
  for (const auto& [cause, times] : contents.defects) json["defects"][cause] = times;
  json["options"] = Json::object();
  for (const auto& [name, value] : contents.options) json["options"][name] = value;
  return json;
}

}  // namespace opal::cli
