#include <opal/map/perceivable_faces.hpp>

namespace opal {

std::vector<Segment> perceivable_faces(const SemanticMap& map) {
  std::vector<Segment> faces;
  for (const MapFeature& feature : map.features())
    if (const auto* face = std::get_if<Segment>(&feature.geometry); face != nullptr && !feature.sensor.empty())
      faces.push_back(*face);
  return faces;
}

}  // namespace opal
