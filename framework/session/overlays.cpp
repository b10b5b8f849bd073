#include "session/overlays.hpp"

#include "map/overlay/map_overlay.hpp"

#include <opal/common/warning.hpp>

namespace opal::session {

MapPtr with_overlays(const MapPtr& map, const std::vector<std::string>& files) {
  if (files.empty()) return map;
  std::vector<opal::MapOverlay> overlays;
  for (const std::string& file : files) overlays.push_back(opal::read_overlay(file));
  const opal::OverlaidMap overlaid = opal::overlaid_map(*map, overlays);
  for (const std::string& doubt : overlaid.doubts) opal::warn("overlay: " + doubt);
  return overlaid.map;
}

}  // namespace opal::session
