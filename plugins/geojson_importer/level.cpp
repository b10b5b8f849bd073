#include "level.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

namespace opal::geojson_importer {
namespace {

constexpr double kMostLevels = 300;

std::optional<double> number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::abs(value) < 1e6
             ? std::optional<double>(value)
             : std::nullopt;
}

std::string written(double level) {
  std::ostringstream text;
  text << level;
  return text.str();
}

/// "1", "-1-2"; what is neither is a name.
void add_levels(const std::string& part, std::vector<std::string>& levels) {
  const std::size_t dash = part.find('-', 1);
  const auto from = number(part.substr(0, dash));
  const auto to = dash == std::string::npos ? from : number(part.substr(dash + 1));
  if (from && to && *from <= *to && *to - *from < kMostLevels)
    for (int k = 0; *from + k <= *to; ++k) levels.push_back(written(*from + k));
  else if (!part.empty())
    levels.push_back(part);
}

/// "0;1", "0, 1": levels one by one.
void add_property(const Feature& feature, const char* key, std::vector<std::string>& levels) {
  std::string text = text_or_number(feature, key);
  std::replace(text.begin(), text.end(), ',', ';');
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ';');) {
    part.erase(0, part.find_first_not_of(' '));
    part.erase(part.find_last_not_of(' ') + 1);
    add_levels(part, levels);
  }
}

/// Of the features that are wanted; from the lowest, names that are no numbers last.
template <class Wanted>
std::vector<std::string> levels_where(const FeatureCollection& collection, Wanted&& is_wanted) {
  std::set<std::pair<double, std::string>> levels;
  for (const Feature& feature : collection.features)
    if (is_wanted(feature))
      for (const std::string& level : levels_of(feature)) levels.emplace(number(level).value_or(1e9), level);
  std::vector<std::string> names;
  for (const auto& [height, name] : levels) names.push_back(name);
  return names;
}

}  // namespace

std::vector<std::string> levels_of(const Feature& feature) {
  std::vector<std::string> levels;
  for (const char* key : {"level", "level_id"})
    if (levels.empty()) add_property(feature, key, levels);
  add_property(feature, "repeat_on", levels);
  return levels;
}

bool is_on_level(const Feature& feature, const std::string& level) {
  const std::vector<std::string> levels = levels_of(feature);
  const std::string wanted = number(level) ? written(*number(level)) : level;
  return levels.empty() || std::find(levels.begin(), levels.end(), wanted) != levels.end();
}

std::vector<std::string> all_levels(const FeatureCollection& collection) {
  return levels_where(collection, [](const Feature&) { return true; });
}

std::string level_at_ground(const FeatureCollection& collection) {
  std::string nearest;
  double least = std::numeric_limits<double>::max();
  for (const std::string& level : levels_where(collection, [](const Feature& feature) { return feature.is_used; })) {
    const double height = number(level).value_or(1e9);
    const double distance = std::abs(height) + (height < 0 ? 0.5 : 0);  // of 1 and -1, the one above
    if (nearest.empty() || distance < least) {
      nearest = level;
      least = distance;
    }
  }
  return nearest;
}

}  // namespace opal::geojson_importer
