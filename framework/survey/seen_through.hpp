#pragma once

#include "survey/expected_features.hpp"

#include <span>

namespace opal {

/// Counts, for every expected surface, whether beams ended on it or passed through where it is believed to be; a beam
/// that ends before it says nothing. Adds at most one keyframe's worth to each side.
/// @param points  where beams ended, base_link frame [m].
void count_seen(MapBelief& belief, const ExpectedFeatures& expected, std::span<const Point> points, const Point& laser,
                const Pose2& T_map_base);

/// Share of the beams that passed through some expected surface, in [0, 1].
double share_through(const ExpectedFeatures& expected, std::span<const Point> points, const Point& laser,
                     const Pose2& T_map_base);

}  // namespace opal
