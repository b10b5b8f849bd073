#include "ros2_bag.hpp"

#include "sqlite_recording.hpp"

#include <opal/common/error.hpp>

#include <fstream>

namespace opal::ros2_bag {
namespace {

bool is_sqlite(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string start(15, '\0');
  return file.read(start.data(), 15) && start == "SQLite format 3";
}

}  // namespace

bool Ros2Bag::recognizes(const std::string& path) const {
  try {
    const std::vector<std::string> files = recording::files_of_recording(path, ".db3");
    return !files.empty() && is_sqlite(files.front()) && !SqliteRecording(files.front()).topics().empty();
  } catch (const std::exception&) {
    return false;
  }
}

recording::Parts Ros2Bag::parts_of(const std::string& path) const {
  recording::Parts parts;
  for (const std::string& file : recording::files_of_recording(path, ".db3"))
    parts.push_back(std::make_unique<SqliteRecording>(file));
  if (parts.empty()) throw LogError(path + ": a folder without .db3 files, expected a ROS 2 recording");
  return parts;
}

}  // namespace opal::ros2_bag
