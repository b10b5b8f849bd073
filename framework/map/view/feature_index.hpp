#pragma once

#include <opal/common/feature.hpp>
#include <opal/map/view/map_view.hpp>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace opal {

/// How many mapped features an observed one may be, going by what it says of itself: a circle's radius, a corner's
/// opening, a segment's length (a lower bound). O(log n).
class FeatureIndex {
 public:
  explicit FeatureIndex(const MapView& map);
  std::size_t expected(const Feature& observed) const;

 private:
  std::map<std::string, std::array<std::vector<double>, 4>> sizes_;  ///< by type and geometry, increasing
};

}  // namespace opal
