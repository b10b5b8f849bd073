#include "ros2_bag.hpp"

#include "sqlite_recording.hpp"

#include <fstream>

namespace opal::ros2_bag {
namespace {

bool is_sqlite(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string start(15, '\0');
  return file.read(start.data(), 15) && start == "SQLite format 3";
}

}  // namespace

bool Ros2Bag::recognizes_file(const std::string& file) const {
  try {
    return is_sqlite(file) && !SqliteRecording(file).topics().empty();
  } catch (const DamagedBag&) {
    return true;  // reading it says so
  }
}

std::unique_ptr<recording::Recording> Ros2Bag::read(const std::string& file) const {
  return std::make_unique<SqliteRecording>(file);
}

}  // namespace opal::ros2_bag
