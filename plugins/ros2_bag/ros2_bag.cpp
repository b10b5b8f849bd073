#include "ros2_bag.hpp"

#include "sqlite_recording.hpp"

#include <opal/common/file_start.hpp>

#include <string_view>

namespace opal::ros2_bag {

bool Ros2Bag::recognizes_file(const std::string& file) const {
  constexpr std::string_view kMagic = "SQLite format 3";
  try {
    return first_bytes(file, kMagic.size()) == kMagic && !SqliteRecording(file).topics().empty();
  } catch (const DamagedBag&) {
    return true;  // reading it says so
  }
}

std::unique_ptr<recording::Recording> Ros2Bag::read(const std::string& file) const {
  return std::make_unique<SqliteRecording>(file);
}

}  // namespace opal::ros2_bag
