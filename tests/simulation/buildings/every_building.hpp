#pragma once

#include "map/check/map_check.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>
#include "simulation/buildings/building.hpp"

inline std::string document_of(const opal::SemanticMap& map) { return map.to_json_ld().dump(1) + '\n'; }

/// The two that there is one of, and of each other kind several seeds, sizes and symmetries.
inline std::vector<opal::simulation::BuildingRequest> every_building() {
  std::vector<opal::simulation::BuildingRequest> requests;
  for (const opal::simulation::BuildingKind& kind : opal::simulation::building_kinds()) {
    if (kind.usual_size_m2 == 0) {
      requests.push_back({kind.name});
      continue;
    }
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      for (const double symmetry : {0.0, 0.5, 1.0})
        for (const double share : {0.4, 2.0})
          requests.push_back({kind.name, seed, share * kind.usual_size_m2, symmetry});
  }
  return requests;
}
