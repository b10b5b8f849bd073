#pragma once

#include <opal/map/semantic_map.hpp>

#include <memory>
#include <string>
#include <vector>

namespace opal::session {

using MapPtr = std::shared_ptr<const opal::SemanticMap>;

/// The map with the overlays of these files; what does not fit is told on stderr. @throws opal::MapError.
MapPtr with_overlays(const MapPtr& map, const std::vector<std::string>& files);

}  // namespace opal::session
