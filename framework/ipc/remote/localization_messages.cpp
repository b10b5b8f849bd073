#include "ipc/remote/localization_messages.hpp"

#include "ipc/remote/json_numbers.hpp"

#include "common/json/event_json.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace opal::remote {
namespace {

using nlohmann::json;

constexpr int kMostBeams = 100'000;
constexpr std::array kStatuses{Status::searching, Status::ambiguous, Status::localized, Status::lost};

/// A range that is no number is null, one that is infinite 1e308: nothing was hit.
constexpr double kInfinite = 1e308;

json range_json(float range_m) {
  if (std::isfinite(range_m)) return range_m;
  return range_m > 0 ? json(kInfinite) : json(nullptr);
}

float range_from(const json& value) {
  if (value.is_null()) return std::numeric_limits<float>::quiet_NaN();
  const double range_m = value.get<double>();
  return range_m > std::numeric_limits<float>::max() ? std::numeric_limits<float>::infinity()
                                                     : static_cast<float>(std::max(range_m, -1.0));
}

std::vector<float> ranges_in(ConfigObject& object) {
  const json& list = object.any("ranges_m");
  if (!list.is_array() || list.size() > kMostBeams)
    object.refuse("ranges_m", fmt::format("a list of at most {} ranges", kMostBeams));
  std::vector<float> ranges;
  for (const json& range : list) {
    if (!range.is_number() && !range.is_null())
      object.refuse("ranges_m", "numbers, or null for a beam that read nothing");
    ranges.push_back(range_from(range));
  }
  return ranges;
}

Status status_in(ConfigObject& object) {
  const std::string name = object.required_text("status");
  for (Status status : kStatuses)
    if (name == name_of(status)) return status;
  object.refuse("status", "searching, ambiguous, localized or lost");
}

PoseEstimate estimate_in(ConfigObject& object) {
  constexpr NumberRange kShare{0, 1};
  PoseEstimate estimate;
  estimate.stamp_s = number_in(object, "stamp_s");
  estimate.status = status_in(object);
  estimate.has_pose = object.boolean("has_pose", false);
  estimate.T_map_base = pose_in(object, "T_map_base");
  estimate.probability = number_in(object, "probability", kShare);
  estimate.none = number_in(object, "none", kShare);
  estimate.hypotheses = object.integer("hypotheses", 0, {0, 1e6});
  estimate.best = HypothesisId(object.integer("best", -1, {-1, 2e9}));
  auto alternatives = object.list("alternatives");
  if (!alternatives) object.refuse("alternatives", "a list");
  for (ConfigObject& alternative : *alternatives) {
    estimate.alternatives.push_back({HypothesisId(alternative.integer("hypothesis", -1, {-1, 2e9})),
                                     pose_in(alternative, "T_map_base"),
                                     number_in(alternative, "probability", kShare)});
    alternative.expect_no_more();
  }
  return estimate;
}

json geometry_json(const Geometry& geometry) {
  nlohmann::ordered_json object;
  add_geometry(object, geometry);
  return object;
}

}  // namespace

json to_json(const LaserModel& laser) {
  return {{"angle_min_rad", laser.angle_min_rad},
          {"angle_increment_rad", laser.angle_increment_rad},
          {"beams", laser.beams},
          {"range_min_m", laser.range_min_m},
          {"range_max_m", laser.range_max_m},
          {"no_return_m", laser.no_return_m},
          {"range_sigma_m", laser.range_sigma_m},
          {"T_base_laser", json(pose_json(laser.T_base_laser))}};
}

LaserModel laser_from(const json& message) {
  ConfigObject object(message, "laser");
  LaserModel laser;
  laser.angle_min_rad = number_in(object, "angle_min_rad", {-10, 10});
  laser.angle_increment_rad = number_in(object, "angle_increment_rad", {-1, 1});
  laser.beams = object.integer("beams", 0, {1, kMostBeams});
  laser.range_min_m = number_in(object, "range_min_m", {0, 1e4});
  laser.range_max_m = number_in(object, "range_max_m", {0.1, 1e4});
  laser.no_return_m = number_in(object, "no_return_m", {0.1, 1e9});
  laser.range_sigma_m = number_in(object, "range_sigma_m", {1e-4, 10});
  laser.T_base_laser = pose_in(object, "T_base_laser");
  object.expect_no_more();
  if (laser.beams < 1) object.refuse("beams", "an integer >= 1");
  if (laser.angle_increment_rad == 0) object.refuse("angle_increment_rad", "a number other than 0");
  return laser;
}

json to_json(const ScanMessage& message) {
  json ranges = json::array();
  for (float range_m : message.scan.ranges_m) ranges.push_back(range_json(range_m));
  json object{{"session", message.session},
              {"stamp_s", message.scan.stamp_s},
              {"T_odom_base", json(pose_json(message.scan.T_odom_base.value()))},
              {"ranges_m", std::move(ranges)}};
  if (message.keep_pattern) object["keep_pattern"] = true;
  return object;
}

ScanMessage scan_from(const json& message) {
  ConfigObject object(message, "scan");
  ScanMessage scan;
  scan.session = object.required_text("session");
  scan.scan.stamp_s = number_in(object, "stamp_s");
  scan.scan.T_odom_base = pose_in(object, "T_odom_base");
  scan.scan.ranges_m = ranges_in(object);
  scan.keep_pattern = object.boolean("keep_pattern", false);
  object.expect_no_more();
  return scan;
}

json to_json(const Answer& answer) {
  const PoseEstimate& said = answer.estimate;
  json alternatives = json::array(), pattern = json::array();
  for (const PoseEstimate::Alternative& alternative : said.alternatives)
    alternatives.push_back({{"hypothesis", alternative.hypothesis},
                            {"T_map_base", json(pose_json(alternative.T_map_base))},
                            {"probability", alternative.probability}});
  for (const Geometry& geometry : answer.pattern) pattern.push_back(geometry_json(geometry));
  return {{"stamp_s", said.stamp_s},
          {"status", name_of(said.status)},
          {"has_pose", said.has_pose},
          {"T_map_base", json(pose_json(said.T_map_base))},
          {"probability", said.probability},
          {"none", said.none},
          {"hypotheses", said.hypotheses},
          {"best", said.best},
          {"alternatives", std::move(alternatives)},
          {"pattern", std::move(pattern)}};
}

Answer answer_from(const json& message) {
  ConfigObject object(message, "answer");
  Answer answer{estimate_in(object), {}};
  auto pattern = object.list("pattern");
  if (!pattern) object.refuse("pattern", "a list");
  for (ConfigObject& geometry : *pattern) answer.pattern.push_back(geometry_in(geometry));
  object.expect_no_more();
  return answer;
}

}  // namespace opal::remote
