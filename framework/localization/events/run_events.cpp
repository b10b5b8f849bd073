#include "localization/events/run_events.hpp"

#include "common/json/event_json.hpp"

namespace opal {
namespace {

using nlohmann::ordered_json;

constexpr int kFormat = 3;

/// With the name that people gave it, if they did.
ordered_json object_json(const MapObject& object) {
  ordered_json json{object.id, object.type};
  if (!object.notes.name.empty()) json.push_back(object.notes.name);
  return json;
}

ordered_json feature_json(const MapFeature& feature, bool perceivable) {
  ordered_json json{
      {"id", feature.id}, {"object", feature.object}, {"type", feature.type}, {"perceivable", perceivable}};
  add_geometry(json, feature.geometry);
  return json;
}

ordered_json pattern_json(const SemanticMap& map, const MapPattern& pattern) {
  ordered_json json{{"id", pattern.id}, {"template", pattern.pattern_template}, {"features", ordered_json::array()}};
  for (MapFeatureNumber number : pattern.features) json["features"].push_back(map.feature(number).id);
  return json;
}

}  // namespace

ordered_json run_event(const RunDescription& description, const LaserModel& laser) {
  return {{"event", "run"},
          {"format", kFormat},
          {"opal", OPAL_VERSION},
          {"log", description.log},
          {"config", description.config},
          {"map", description.map},
          {"sensor", laser.id},
          {"T_base_laser", pose_json(laser.T_base_laser)},
          {"range_max_m", laser.range_max_m}};
}

ordered_json map_event(const MapView& view) {
  const SemanticMap& map = view.map();
  ordered_json e{{"event", "map"},
                 {"name", map.name()},
                 {"objects", ordered_json::array()},
                 {"features", ordered_json::array()},
                 {"patterns", ordered_json::array()}};
  for (const MapObject& object : map.objects()) e["objects"].push_back(object_json(object));
  std::vector<bool> perceivable(map.features().size(), false);
  for (MapFeatureNumber number : view.features()) perceivable[number.number()] = true;
  for (std::size_t k = 0; k < map.features().size(); ++k)
    e["features"].push_back(feature_json(map.features()[k], perceivable[k]));
  for (const MapStorey& storey : map.origin().storeys)
    e["storeys"].push_back(
        {{"id", storey.id},
         {"name", words_for(map, {storey.building, storey.id, {}})},
         {"origin", {storey.origin.x(), storey.origin.y()}},
         {"bounds", {storey.bounds[0].x(), storey.bounds[0].y(), storey.bounds[1].x(), storey.bounds[1].y()}}});
  for (const MapPattern& pattern : map.patterns()) e["patterns"].push_back(pattern_json(map, pattern));
  return e;
}

ordered_json start_event(const std::string& name) { return {{"event", "start"}, {"query", name}}; }

ordered_json truth_event(std::span<const StampedPose> poses) {
  constexpr double kStep_s = 0.05;
  ordered_json e{{"event", "truth"}, {"poses", ordered_json::array()}};
  double written_s = -std::numeric_limits<double>::infinity();
  for (const StampedPose& pose : poses) {
    if (pose.stamp_s < written_s + kStep_s) continue;
    written_s = pose.stamp_s;
    e["poses"].push_back({pose.stamp_s, pose.pose.x(), pose.pose.y(), pose.pose.heading_rad()});
  }
  return e;
}

}  // namespace opal
