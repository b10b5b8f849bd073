#include "ros2_bag.hpp"

#include "bag_file.hpp"
#include "bag_reader.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

namespace opal::ros2_bag {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> database_files(const std::string& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ".db3") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

bool is_sqlite(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string start(15, '\0');
  return file.read(start.data(), 15) && start == "SQLite format 3";
}

std::set<std::string> topics_of_type(const std::vector<BagFile>& files, const std::string& type) {
  std::set<std::string> names;
  for (const BagFile& file : files)
    for (const Topic& topic : file.topics())
      if (topic.type == type) names.insert(topic.name);
  return names;
}

std::string listed(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

/// @return empty if there is no topic of this type and none is asked for.
std::string choose(const std::string& path, const std::set<std::string>& topics, const std::string& type,
                   const std::string& wanted, const std::string& usual, const std::string& option) {
  if (!wanted.empty() && !topics.contains(wanted))
    throw LogError(path + ": no topic " + wanted + " of type " + type + " in CDR, there is " + listed(topics));
  if (!wanted.empty()) return wanted;
  if (topics.size() <= 1) return topics.empty() ? "" : *topics.begin();
  if (topics.contains(usual)) return usual;
  throw LogError(path + ": several topics of type " + type + " (" + listed(topics) +
                 "), expected an option to choose one: " + option + "=" + *topics.begin());
}

}  // namespace

bool Ros2Bag::recognizes(const std::string& path) const {
  try {
    const std::vector<std::string> files = database_files(path);
    return !files.empty() && is_sqlite(files.front()) && !BagFile(files.front()).topics().empty();
  } catch (const std::exception&) {
    return false;
  }
}

std::unique_ptr<LogReader> Ros2Bag::open(const std::string& path) const {
  std::vector<BagFile> files;
  for (const std::string& file : database_files(path)) files.emplace_back(file);
  if (files.empty()) throw LogError(path + ": a folder without .db3 files, expected a ROS 2 recording");
  std::stable_sort(files.begin(), files.end(),
                   [](const BagFile& a, const BagFile& b) { return a.begin_s() < b.begin_s(); });
  const std::string scan_type = "sensor_msgs/msg/LaserScan";
  const std::string odometry_type = "nav_msgs/msg/Odometry";
  const TopicChoice chosen{
      choose(path, topics_of_type(files, scan_type), scan_type, topics_.scan, "/scan", "scan_topic"),
      choose(path, topics_of_type(files, odometry_type), odometry_type, topics_.odometry, "/odom", "odometry_topic"),
      topics_.odom_frame, topics_.base_frame};
  if (chosen.scan.empty()) throw LogError(path + ": no topic of type " + scan_type + " in CDR");
  return std::make_unique<BagReader>(std::move(files), chosen);
}

}  // namespace opal::ros2_bag
