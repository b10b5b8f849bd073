#pragma once

#include "map_tools/map_raster.hpp"
#include "ros2/messages/announcement.hpp"
#include "ros2/messages/diagnosis.hpp"
#include "ros2/network/participant.hpp"

#include <opal/map/semantic_map.hpp>

namespace opal::ros2 {

/// Where is published what.
struct OutgoingTopics {
  std::string tf = "/tf";  ///< map to odom
  std::string pose = "/amcl_pose";
  std::string places = "/opal/places";          ///< PoseArray
  std::string markers = "/opal/place_markers";  ///< MarkerArray: places with their probabilities
  std::string map = "/opal/map";                ///< OccupancyGrid; /map belongs to the map server of Nav2
  std::string walls = "/opal/walls";            ///< MarkerArray: what the semantic map says is there
  std::string diagnostics = "/diagnostics";
};

/// Publishes. One thread at a time.
class Outgoing {
 public:
  Outgoing(const Participant& participant, const OutgoingTopics& topics, FrameOptions frames);

  void publish(const Announcement& announcement);
  void publish(const std::vector<Diagnosis>& diagnoses, double now_s);
  /// Once: who comes later gets it, too.
  void publish(const MapRaster& raster, double now_s);
  void publish_walls(const SemanticMap& map, double now_s);

 private:
  FrameOptions frames_;
  bool shows_places_ = false;
  Entity tf_, pose_, places_, markers_, map_, walls_, diagnostics_;
};

}  // namespace opal::ros2
