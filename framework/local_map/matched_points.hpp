#pragma once

#include <opal/local_map/local_map.hpp>

#include <deque>
#include <vector>

namespace opal {

/// The points of all lasers that are finite, laser after laser; base_link frame [m].
OPAL_EXPORT std::vector<Point> points_in_base(const Sample& sample);

/// What a new scan is laid over: points of the last keyframes around `position`, oldest keyframe first, in frame
/// `local`, thinned. Small things that one keyframe alone saw are left out: a person who walks along with the robot
/// looks like one who stands beside a robot that stands.
OPAL_EXPORT std::vector<Point> matched_points(const Point& position, const std::deque<Keyframe>& keyframes);

}  // namespace opal
