#pragma once

#include "building.hpp"
#include "region.hpp"

#include <stdexcept>

namespace opal::ifc_importer {

/// What a solid cuts out of the horizontal plane at a height. Points exactly in the plane count as below it.
/// @throws OpenSurface if its faces enclose nothing there.
Region cut(const Body& body, double height_m);
Region cut(const std::vector<Body>& bodies, double height_m);

/// Lowest and highest point of what a solid adds [m]; infinite for a half space.
struct Span {
  double low_m, high_m;
};
Span span_of(const std::vector<Body>& bodies);

struct OpenSurface : std::runtime_error {
  OpenSurface() : std::runtime_error("its surface is not closed at this height") {}
};

}  // namespace opal::ifc_importer
