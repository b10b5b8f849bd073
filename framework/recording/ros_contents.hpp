#pragma once

#include "recording/ros_topics.hpp"

namespace opal::recording {

/// What a recording holds: all topics by the files' indices; lasers, odometry and frames by their messages, up to a few
/// hundred megabytes of them.
/// @param parts  by time, those without messages last; at least one. @param first  where a topic and transforms both
/// have odometry.
LogContents ros_contents(const std::string& path, const Parts& parts, TopicChoice wanted,
                         OdometryFirst first = OdometryFirst::topic);

}  // namespace opal::recording
