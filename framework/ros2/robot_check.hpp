#pragma once

#include "recording/ros_topics.hpp"
#include "ros2/incoming.hpp"

#include <opal/recording/ros_log.hpp>

#include <stop_token>

namespace opal::ros2 {

/// What was seen of a robot.
struct RobotContents {
  LogContents contents;              ///< as of a recording of the same time
  std::vector<Offer> offers;         ///< all topics with their quality of service
  std::vector<std::string> missing;  ///< what localization needs and is not there
  std::vector<std::string> doubts;   ///< what it can do without, and a user should know
};

/// Whether this topic has to speak: scans or odometry that are named are read from it.
bool is_chosen(const recording::TopicChoice& choice, const std::string& topic);

/// Listens to a robot for a while, and publishes nothing.
/// @param choice  which scans and odometry would be read; without scans all are.
/// @param first  where a topic and transforms both have odometry.
/// @throws Error if DDS cannot be started.
RobotContents look_at_robot(const DiscoveryRange& range, const recording::TopicChoice& choice,
                            recording::OdometryFirst first, double seconds, const std::stop_token& stop);

/// The offers as a table: topic, type, quality of service.
std::string offers_text(const std::vector<Offer>& offers);

}  // namespace opal::ros2
