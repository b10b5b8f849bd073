#pragma once

#include <opal/map/view/map_view.hpp>

namespace opal {

/// The connecting line of two mapped features: between their places, or to the nearest point of a face.
Segment connecting_line(const Geometry& a, const Geometry& b);

/// True if nothing that the sensor perceives stands between the two features (Hendrikx 2023, 4.4.1), and both are open
/// to each other's side: the line leaves a corner into its opening, and a face on its visible side.
bool see_each_other(const MapView& map, MapFeatureNumber a, MapFeatureNumber b);

}  // namespace opal
