#include "ros2/messages/outgoing.hpp"

#include "ros2/messages/wire_types.hpp"

namespace opal::ros2 {
namespace {

// As visualization_msgs/Marker numbers it, and a thickness that can be seen.
constexpr std::int32_t kLineList = 5;
constexpr double kLineM = 0.04;

/// As nav_msgs/OccupancyGrid has it: per cent, or -1 for unknown.
std::uint8_t occupancy_of(MapRaster::Cell cell) {
  if (cell == MapRaster::Cell::occupied) return 100;
  return cell == MapRaster::Cell::free ? 0 : static_cast<std::uint8_t>(-1);
}

}  // namespace

void Outgoing::publish(const MapRaster& raster, double now_s) {
  std::vector<std::uint8_t> cells;
  cells.reserve(raster.cells.size());
  for (const MapRaster::Cell cell : raster.cells) cells.push_back(occupancy_of(cell));
  nav_msgs_msg_dds__OccupancyGrid_ message{};
  message.header = wire_header(now_s, frames_.map);
  message.info.map_load_time = wire_time(now_s);
  message.info.resolution = static_cast<float>(raster.resolution_m);
  message.info.width = static_cast<std::uint32_t>(raster.columns);
  message.info.height = static_cast<std::uint32_t>(raster.rows);
  message.info.origin = wire_pose({raster.origin, 0});
  message.data = wire_sequence<decltype(message.data)>(cells);
  dds_write(map_.handle(), &message);
}

void Outgoing::publish_walls(const SemanticMap& map, double now_s) {
  static const std::string kKind = "opal walls";
  std::vector<geometry_msgs_msg_dds__Point_> points;
  for (const MapFeature& feature : map.features()) {
    const auto* segment = std::get_if<Segment>(&feature.geometry);
    if (segment == nullptr) continue;
    points.push_back({segment->begin.x(), segment->begin.y(), 0});
    points.push_back({segment->end.x(), segment->end.y(), 0});
  }
  std::vector<WireMarker> markers{wire_marker(wire_header(now_s, frames_.map), kKind, 0, kLineList)};
  markers[0].scale.x = kLineM;
  markers[0].color.b = 1;
  markers[0].points = wire_sequence<decltype(markers[0].points)>(points);
  visualization_msgs_msg_dds__MarkerArray_ message{};
  message.markers = wire_sequence<decltype(message.markers)>(markers);
  dds_write(walls_.handle(), &message);
}

}  // namespace opal::ros2
