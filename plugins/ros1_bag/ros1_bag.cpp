#include "ros1_bag.hpp"

#include "bag_recording.hpp"

#include <opal/common/error.hpp>

namespace opal::ros1_bag {

bool Ros1Bag::recognizes(const std::string& path) const {
  try {
    const std::vector<std::string> files = recording::files_of_recording(path, ".bag");
    return !files.empty() && is_bag(files.front());
  } catch (const std::exception&) {
    return false;
  }
}

recording::Parts Ros1Bag::parts_of(const std::string& path) const {
  recording::Parts parts;
  for (const std::string& file : recording::files_of_recording(path, ".bag")) parts.push_back(read_bag(file));
  if (parts.empty()) throw LogError(path + ": a folder without .bag files, expected a bag of ROS 1");
  return parts;
}

}  // namespace opal::ros1_bag
