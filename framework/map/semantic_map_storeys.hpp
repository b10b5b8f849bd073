#pragma once

#include "map/semantic_map_draft.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace opal {

/// From a point to an axis-parallel rectangle [m]; 0 inside. @param box  least and greatest corner.
inline double distance_to_box_m(const std::array<Point, 2>& box, const Point& p) {
  return (box[0] - p).cwiseMax(p - box[1]).cwiseMax(Point::Zero()).norm();
}

/// The sheet on which a point lies: of all with `bounds` the nearest, of equally near ones the first; null if there is
/// none, or the point is not finite.
template <class Sheet>
const Sheet* nearest_sheet(const std::vector<Sheet>& all, const Point& p) {
  const Sheet* nearest = nullptr;
  double least_m = std::numeric_limits<double>::infinity();
  for (const Sheet& one : all)
    if (const double distance_m = distance_to_box_m(one.bounds, p); distance_m < least_m) {
      least_m = distance_m;
      nearest = &one;
    }
  return nearest;
}

/// Of buildings or storeys; null if none has the id.
template <class All>
auto with_id(All& all, std::string_view id) -> decltype(all.data()) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.id == id; });
  return found == all.end() ? nullptr : &*found;
}

/// "'low', 'top'"; empty without storeys.
OPAL_EXPORT std::string ids_of(const std::vector<MapStorey>& storeys);

/// Full IRIs and bare terms become prefixed names, as `name_everything` does for the rest.
void name_storeys(MapDraft& draft);
/// In natural order of id; landings in that of their storeys.
void sort_storeys(MapOrigin& origin);

/// Measures each sheet; sheets are apart, everything lies on one, and connections connect storeys that there are.
/// @throws MapError.
void check_storeys(MapDraft& draft);

}  // namespace opal
