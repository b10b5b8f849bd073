#include <opal/recording/ros_log.hpp>

#include <opal/common/error.hpp>
#include "common/phrases.hpp"
#include "recording/ros_contents.hpp"
#include "recording/ros_log_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace opal::recording {
namespace {

namespace fs = std::filesystem;

bool is_empty(const Recording& part) { return part.span_ns() == std::pair<std::int64_t, std::int64_t>(0, 0); }

/// The files of one recording may have any names: their messages tell the order. Those without any come last.
Parts by_time(Parts parts) {
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return std::pair(is_empty(*a), span_of(*a).begin_s) < std::pair(is_empty(*b), span_of(*b).begin_s);
  });
  return parts;
}

/// The files with this ending in a folder by name, or the path itself if it is no folder.
std::vector<std::string> files_in(const std::string& path, const std::string& ending) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ending) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

std::string name_of(const std::string& file) { return fs::path(file).filename().string(); }

std::vector<std::string> names_of(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  std::transform(files.begin(), files.end(), std::back_inserter(names), name_of);
  return names;
}

/// Whether the files are NAME_0, NAME_1 ...; in ROS 1 the time when each was begun may stand before the number.
bool are_numbered(const std::vector<std::string>& files) {
  static const std::regex kNumbered("(.*?)([0-9]{4}(-[0-9]{2}){5})?_([0-9]+)");
  std::set<std::string> names, numbers;
  for (const std::string& file : files) {
    const std::string stem = fs::path(file).stem().string();
    std::smatch parts;
    if (!std::regex_match(stem, parts, kNumbered)) return false;
    names.insert(parts[1]);
    numbers.insert(parts[4]);
  }
  return names.size() == 1 && numbers.size() == files.size();
}

/// What rosbag2 says of the parts of what it recorded into a folder.
std::string metadata_of(const std::string& folder) {
  std::ifstream list(fs::path(folder) / "metadata.yaml");
  return std::string(std::istreambuf_iterator<char>(list), {});
}

std::string_view without(std::string_view text, std::string_view around) {
  const std::size_t first = text.find_first_not_of(around);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(around) - first + 1);
}

/// NAME_0.db3 of "  - NAME_0.db3" and of "  - path: 'NAME_0.db3'".
std::string listed_in(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r";
  line = without(line, kBlanks);
  for (const std::string_view before : {"- ", "path: "})
    if (line.starts_with(before)) line = without(line.substr(before.size()), kBlanks);
  return std::string(without(line, "\"'"));
}

/// The parts that it lists, and that are not there.
std::vector<std::string> absent_parts(const std::string& folder, const std::string& ending) {
  std::set<std::string> absent;
  std::istringstream lines(fs::is_directory(folder) ? metadata_of(folder) : "");
  for (std::string line; std::getline(lines, line);) {
    const std::string file = listed_in(line), name = name_of(file);
    if (file.ends_with(ending) && !fs::exists(fs::path(folder) / name)) absent.insert(name);
  }
  return {absent.begin(), absent.end()};
}

std::string absence_words(const std::vector<std::string>& absent) {
  return "metadata.yaml names " + listed(absent) + ", and no such file is there: that part of the recording is missing";
}

/// Whether rosbag2 has listed all files as parts of what it recorded into this folder.
bool are_listed(const std::string& folder, const std::vector<std::string>& files) {
  const std::string text = metadata_of(folder);
  return std::all_of(files.begin(), files.end(),
                     [&](const std::string& file) { return text.find(name_of(file)) != std::string::npos; });
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
  TopicChoice choice{std::move(scans), options.at("odometry_topic"), options.at("odom_frame"),
                     options.at("base_frame")};
  choice.hints = options.value("hint_topic", "");
  return choice;
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
  if (choice.scans.empty() && all_named) choice.scans = others;
  return choice;
}

bool RosLogSource::recognizes(const std::string& path) const {
  try {
    const std::vector<std::string> files = files_in(path, ending());
    return !files.empty() && recognizes_file(files.front());
  } catch (const std::exception&) {
    return false;
  }
}

std::vector<std::string> RosLogSource::files_of(const std::string& path) const {
  std::vector<std::string> files = files_in(path, ending());
  if (files.empty()) throw LogError(path + ": a folder without " + ending() + " files, expected a " + format());
  if (files.size() > 1 && !are_listed(path, files) && !are_numbered(files))
    throw LogError(path + ": several recordings (" + listed(names_of(files)) +
                   "), expected one of them, or a folder with the parts of one: NAME_0, NAME_1 ..., or those that its "
                   "metadata.yaml names");
  return files;
}

Parts RosLogSource::parts_of(const std::vector<std::string>& files) const {
  Parts parts;
  for (const std::string& file : files) parts.push_back(read(file));
  return by_time(std::move(parts));
}

std::unique_ptr<LogReader> RosLogSource::open(const std::string& path) const { return open_with(path, topics_); }

std::unique_ptr<LogReader> RosLogSource::open_for(const std::string& path,
                                                  const std::vector<LaserModel>& lasers) const {
  const TopicChoice topics = with_topics_of(topics_, lasers);
  expect_laser_each(topics, lasers.size());
  return open_with(path, topics);
}

std::unique_ptr<LogReader> RosLogSource::open_with(const std::string& path, const TopicChoice& topics) const {
  Parts parts = parts_of(files_of(path));
  ChosenTopics chosen = choose_topics(path, parts, topics);
  if (const auto absent = absent_parts(path, ending()); !absent.empty())
    chosen.remarks.push_back(absence_words(absent));
  return std::make_unique<RosLogReader>(std::move(parts), std::move(chosen));
}

LogContents RosLogSource::contents(const std::string& path) const {
  const std::vector<std::string> files = files_of(path);
  LogContents contents = ros_contents(path, parts_of(files), topics_);
  if (const auto absent = absent_parts(path, ending()); !absent.empty()) ++contents.defects[absence_words(absent)];
  contents.format = format() + (fs::is_directory(path) ? " of " + listed(names_of(files)) : "");
  return contents;
}

}  // namespace opal::recording
