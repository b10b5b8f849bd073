#include <opal/recording/ros_log.hpp>

#include <opal/common/error.hpp>
#include "recording/ros_contents.hpp"
#include "recording/ros_log_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace opal::recording {
namespace {

namespace fs = std::filesystem;

/// The files of one recording may have any names: their messages tell the order.
Parts by_time(Parts parts) {
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return span_of(*a).begin_s < span_of(*b).begin_s; });
  return parts;
}

/// "/front, /rear" or "/front /rear", for no topic has blanks in its name: each name once.
std::vector<std::string> names_in(std::string list) {
  std::replace(list.begin(), list.end(), ',', ' ');
  std::vector<std::string> names;
  std::istringstream words(list);
  for (std::string name; words >> name;)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

}  // namespace

TopicChoice topic_choice(const nlohmann::json& options) {
  std::vector<std::string> scans = names_in(options.at("scan_topics").get<std::string>());
  const std::string scan = options.at("scan_topic");
  if (!scan.empty() && std::find(scans.begin(), scans.end(), scan) == scans.end()) scans.insert(scans.begin(), scan);
  return {std::move(scans), options.at("odometry_topic"), options.at("odom_frame"), options.at("base_frame")};
}

TopicChoice with_topics_of(TopicChoice choice, const std::vector<LaserModel>& lasers) {
  std::vector<std::string> others;
  bool all_named = true;
  for (const LaserModel& laser : lasers) {
    if (laser.slice)
      choice.slices[laser.topic] = laser;
    else
      others.push_back(laser.topic);
    all_named = all_named && !laser.topic.empty();
  }
  std::erase_if(choice.scans, [&](const std::string& topic) { return choice.slices.contains(topic); });
  choice.are_all_slices = !choice.slices.empty() && others.empty();
  const bool are_several = lasers.size() > 1 || !choice.slices.empty();
  if (are_several && choice.scans.empty() && all_named) choice.scans = others;
  return choice;
}

std::unique_ptr<LogReader> RosLogSource::open(const std::string& path) const { return open_with(path, topics_); }

std::unique_ptr<LogReader> RosLogSource::open_for(const std::string& path,
                                                  const std::vector<LaserModel>& lasers) const {
  return open_with(path, with_topics_of(topics_, lasers));
}

std::unique_ptr<LogReader> RosLogSource::open_with(const std::string& path, const TopicChoice& topics) const {
  Parts parts = by_time(parts_of(path));
  ChosenTopics chosen = choose_topics(path, parts, topics);
  return std::make_unique<RosLogReader>(std::move(parts), std::move(chosen));
}

LogContents RosLogSource::contents(const std::string& path) const {
  LogContents contents = ros_contents(path, by_time(parts_of(path)), topics_);
  contents.format = format();
  return contents;
}

std::vector<std::string> files_of_recording(const std::string& path, const std::string& ending) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ending) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace opal::recording
