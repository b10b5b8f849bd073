#pragma once

#include <opal/map/view/map_view.hpp>
#include <opal/sensing/scan.hpp>
#include "sensing/trajectory.hpp"

#include <nlohmann/json.hpp>

#include <span>
#include <string>

namespace opal {

/// The events that only the caller of a `Localizer` can write, because only it knows them; docs/events.md. A stream
/// that `opal view` can show begins with `run_event`, `map_event` and, for every new time line, `start_event`.

/// Where a run's input came from; names as a reader should see them.
struct RunDescription {
  std::string log, config, map;
};

OPAL_EXPORT nlohmann::ordered_json run_event(const RunDescription& description, const LaserModel& laser);
OPAL_EXPORT nlohmann::ordered_json map_event(const MapView& view);
/// A new time line: the localizer has been reset.
OPAL_EXPORT nlohmann::ordered_json start_event(const std::string& name);
/// @param poses  T_map_base by increasing stamp; those nearer than 0.05 s to the one before are left out.
OPAL_EXPORT nlohmann::ordered_json truth_event(std::span<const StampedPose> poses);

}  // namespace opal
