#pragma once

#include <opal/map/semantic_map.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace opal {

/// How a map is made worse, to measure what a localizer makes of wrong maps: building models miss walls, hold walls
/// that were never built, and are off by decimetres. Applied in the order of the fields; zero: not at all.
struct MapDamage {
  double thick_m = 0;  ///< walls of a grid become thicker by this, before it is imported (see session.hpp's import)
  double plan_m = 0;   ///< segments shorter than this are deleted: a plan holds no clutter
  double drop = 0;     ///< share of the segments that are deleted
  double wall_m = 0;   ///< whole walls are moved along the normal of their longest face by up to this much,
  double wall_share = 0.3;  ///< so many of them
  double shift_m = 0;       ///< standard deviation by which every segment is moved along its normal
  double false_share = 0;   ///< segments that do not exist, as a share of those that are left
  std::uint64_t seed = 1;
};

/// Reads "thick=0.4,drop=0.3,shift=0.1,wall=0.6,wall_share=0.3,false=0.3,plan=1.5"; what is not named stays as in
/// `damage`.
/// @throws ConfigError naming the part, what was found and what was expected.
OPAL_EXPORT MapDamage read_map_damage(const std::string& text, MapDamage damage = {});

/// The map, worse; thick_m is done to grids and not here. Corners go with their faces: moved to where the faces meet
/// now, deleted if one is gone. The same map, damage and seed give the same map.
OPAL_EXPORT std::shared_ptr<const SemanticMap> damaged_map(const SemanticMap& map, const MapDamage& damage);

}  // namespace opal
