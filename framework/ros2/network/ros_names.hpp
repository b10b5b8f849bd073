#pragma once

#include <string>

namespace opal::ros2 {

// Names of ROS 2 and what its middlewares make of them: https://design.ros2.org/articles/topic_and_service_names.html

/// The whole name of a topic. @param name_space  of this node: "", "robot1", "/robot1". @param name  "scan", or
/// "/scan", which is whole already.
std::string topic_in(const std::string& name_space, const std::string& name);
/// "/scan" -> "rt/scan"
std::string dds_topic(const std::string& topic);
/// "rt/scan" -> "/scan"; empty for what is no topic of ROS.
std::string ros_topic(const std::string& dds_topic);
/// "sensor_msgs::msg::dds_::LaserScan_" -> "sensor_msgs/msg/LaserScan"; other names stay.
std::string ros_type(const std::string& dds_type);
/// Whether names may be written like this: letters, digits and _, no digit first, parts between slashes.
bool is_topic_name(const std::string& name);

}  // namespace opal::ros2
