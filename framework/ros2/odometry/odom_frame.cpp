#include "ros2/odometry/odom_frame.hpp"

#include "common/phrases.hpp"

namespace opal::ros2 {

OdomFrame odom_frame_of(const std::string& stated, bool is_stated, const std::string& named) {
  if (named.empty() || named == stated) return {stated, ""};
  const std::string words = "messages of odometry are in frame " + in_quotes(named);
  if (!is_stated) return {named, words + ": the transform from the map leads to it"};
  return {stated,
          words + ", and odom_frame is " + in_quotes(stated) + ": the transform from the map leads to the latter"};
}

}  // namespace opal::ros2
