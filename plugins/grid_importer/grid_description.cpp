#include "grid_description.hpp"

#include <opal/common/error.hpp>
#include <opal/common/letter_case.hpp>

#include <yaml-cpp/yaml.h>

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace opal::grid_importer {
namespace {

// A map_server yaml file has seven short lines; anything much larger is something else.
constexpr std::size_t kMaxTextBytes = 64 * 1024;

std::string place_of(const YAML::Mark& mark) { return fmt::format("line {}", mark.line + 1); }

/// One `key: value` of the file, able to say where it stands.
class Entry {
 public:
  Entry(const std::string& file, std::string key, const YAML::Node& value)
      : file_(file), key_(std::move(key)), value_(value) {}

  [[noreturn]] void refuse(const std::string& expected) const {
    throw MapError(file_ + ": " + place_of(value_.Mark()) + ": " + key_ + ": " + found() + ", expected " + expected);
  }

  std::string text() const {
    if (!value_.IsScalar() || value_.Scalar().empty()) refuse("a text");
    return value_.Scalar();
  }

  double number(const YAML::Node& node, const std::string& expected) const {
    double number = 0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, number) || !std::isfinite(number)) refuse(expected);
    return number;
  }
  double number(const std::string& expected) const { return number(value_, expected); }

  bool flag() const {
    const std::string word = text();
    if (word == "0" || word == "1") return word == "1";
    bool value = false;
    if (!YAML::convert<bool>::decode(value_, value)) refuse("0 or 1");
    return value;
  }

  /// @param lacks_yaw  whether the yaw is NaN; then it is 0.
  Pose2 pose(bool& lacks_yaw) const {
    const std::string expected = "[x, y, yaw], three finite numbers";
    if (!value_.IsSequence() || value_.size() != 3) refuse(expected);
    double yaw_rad = 0;
    lacks_yaw = value_[2].IsScalar() && lower_case_letters(value_[2].Scalar()).ends_with("nan");
    if (!lacks_yaw) yaw_rad = number(value_[2], expected);
    return {number(value_[0], expected), number(value_[1], expected), yaw_rad};
  }

 private:
  std::string found() const {
    const std::string written = YAML::Dump(value_);
    return written.size() <= 60 ? written : written.substr(0, 57) + "...";
  }

  const std::string& file_;
  std::string key_;
  YAML::Node value_;
};

double threshold(const Entry& entry) {
  const std::string expected = "a number from 0 to 1";
  const double value = entry.number(expected);
  if (value < 0 || value > 1) entry.refuse(expected);
  return value;
}

double resolution(const Entry& entry) {
  // Floors and ceilings of what a building's grid can sensibly be; a coordinate stays far below 1e9 m.
  const std::string expected = "a cell size from 0.001 to 10 m";
  const double value_m = entry.number(expected);
  if (value_m < 0.001 || value_m > 10) entry.refuse(expected);
  return value_m;
}

Pose2 origin(const Entry& entry, bool& lacks_yaw) {
  const Pose2 pose = entry.pose(lacks_yaw);
  if (pose.position().norm() > 1e7) entry.refuse("an origin within 10000 km of the map's zero");
  return pose;
}

GridMode mode(const Entry& entry) {
  static const std::map<std::string, GridMode> kModes{
      {"trinary", GridMode::trinary}, {"scale", GridMode::scale}, {"raw", GridMode::raw}};
  const auto known = kModes.find(lower_case_letters(entry.text()));
  if (known == kModes.end()) entry.refuse("trinary, scale or raw");
  return known->second;
}

using Reader = std::function<void(const Entry&, GridDescription&)>;

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> kReaders{
      {"image", [](const Entry& e, GridDescription& d) { d.image = e.text(); }},
      {"resolution", [](const Entry& e, GridDescription& d) { d.resolution_m = resolution(e); }},
      {"origin", [](const Entry& e, GridDescription& d) { d.T_map_grid = origin(e, d.lacks_yaw); }},
      {"mode", [](const Entry& e, GridDescription& d) { d.mode = mode(e); }},
      {"negate", [](const Entry& e, GridDescription& d) { d.negate = e.flag(); }},
      {"occupied_thresh", [](const Entry& e, GridDescription& d) { d.occupied_threshold = threshold(e); }},
      {"free_thresh", [](const Entry& e, GridDescription& d) { d.free_threshold = threshold(e); }},
  };
  return kReaders;
}

YAML::Node load(const std::string& text, const std::string& name) {
  if (text.size() > kMaxTextBytes)
    throw MapError(
        fmt::format("{}: {} bytes, expected a map_server yaml file of at most {}", name, text.size(), kMaxTextBytes));
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw MapError(name + ": " + place_of(error.mark) + ": not valid YAML: " + error.msg);
  }
}

std::string key_text(const YAML::Node& key, const std::string& name) {
  if (!key.IsScalar()) throw MapError(name + ": " + place_of(key.Mark()) + ": a key that is not a word");
  return key.Scalar();
}

void require(const std::set<std::string>& seen, const std::string& name) {
  for (const char* key : {"image", "resolution", "origin"})
    if (!seen.count(key)) throw MapError(name + ": " + key + " is missing, expected in every map_server yaml file");
}

void read_entries(const YAML::Node& root, const std::string& name, GridDescription& description) {
  if (!root.IsMap()) throw MapError(name + ": line 1: expected \"key: value\" lines of a map_server yaml file");
  std::set<std::string> seen;
  for (const auto& pair : root) {
    const std::string key = key_text(pair.first, name);
    const Entry entry(name, key, pair.second);
    const bool is_new = seen.insert(key).second;
    const auto reader = readers().find(key);
    if (reader == readers().end()) {
      if (is_new) description.ignored_keys.push_back(key);
      continue;
    }
    if (!is_new) entry.refuse("this key only once");
    reader->second(entry, description);
  }
  require(seen, name);
}

}  // namespace

GridDescription parse_description(const std::string& text, const std::string& name) {
  GridDescription description;
  try {
    read_entries(load(text, name), name, description);
  } catch (const YAML::Exception& error) {
    throw MapError(name + ": " + place_of(error.mark) + ": not valid YAML: " + error.msg);
  }
  return description;
}

}  // namespace opal::grid_importer
