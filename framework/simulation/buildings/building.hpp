#pragma once

#include <opal/map/semantic_map.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace opal::simulation {

/// What to build.
struct BuildingRequest {
  std::string kind;        ///< one of building_kinds()
  std::uint64_t seed = 0;  ///< the same seed gives the same building, to the byte
  double size_m2 = 0;      ///< floor and what stands on it, about; 0: as is usual for the kind
  double symmetry = 0.5;   ///< 0: all parts differ; 1: all are copies of one, ambiguous up to the ends
};

/// A building of our own.
struct Building {
  std::shared_ptr<const SemanticMap> map;
  /// Distance along x after which the same parts come again where all are as usual [m]; 0: none do.
  double module_m = 0;
};

struct BuildingKind {
  std::string name;
  std::string description;
  double usual_size_m2 = 0;  ///< 0: there is only one, which takes no seed, size or symmetry
};
const std::vector<BuildingKind>& building_kinds();

/// @throws ConfigError naming what was asked for and what there is: an unknown kind, a size outside [100, 100000] m^2,
/// a symmetry outside [0, 1].
Building generate_building(const BuildingRequest& request);

}  // namespace opal::simulation
