#include "level.hpp"

#include <opal/common/error.hpp>
#include <opal/common/letter_case.hpp>
#include <opal/common/number_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace opal::geojson_importer {
namespace {

constexpr double kMostLevels = 300;
// OpenStreetMap, IMDF. Each feature may say its level by any of these.
constexpr std::array kUsual{"level", "level_id", "levelid"};
// Of plans that have none of these, in this order.
constexpr std::array kOthers{"floor", "floorid", "floor_id", "storey", "storey_id"};
// Names of properties that may mean a level.
constexpr std::array kLikeLevels{"level", "floor", "storey", "story", "etage", "geschoss", "stockwerk"};

std::optional<double> number(const std::string& text) {
  const auto value = parse_number<double>(text);
  return value && std::abs(*value) < 1e6 ? value : std::nullopt;
}

std::string written(double level) {
  std::ostringstream text;
  text << level;
  return text.str();
}

/// "1", "-1-2", also from above: "-1--3"; what is none of these is a name.
void add_levels(const std::string& part, std::vector<std::string>& levels) {
  const std::size_t dash = part.find('-', 1);
  auto from = number(part.substr(0, dash));
  auto to = dash == std::string::npos ? from : number(part.substr(dash + 1));
  if (from && to && *from > *to) std::swap(from, to);
  if (from && to && *from <= *to && *to - *from < kMostLevels)
    for (int k = 0; *from + k <= *to; ++k) levels.push_back(written(*from + k));
  else if (!part.empty())
    levels.push_back(part);
}

/// "0;1", "0, 1": levels one by one.
void add_property(const Feature& feature, const std::string& key, std::vector<std::string>& levels) {
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
      for (const std::string& level : feature.levels) levels.emplace(number(level).value_or(1e9), level);
  std::vector<std::string> names;
  for (const auto& [height, name] : levels) names.push_back(name);
  return names;
}

bool any_has(const FeatureCollection& collection, const std::string& property) {
  return std::ranges::any_of(collection.features,
                             [&](const Feature& feature) { return !text_or_number(feature, property).empty(); });
}

/// Which properties say the levels of a plan.
std::vector<std::string> properties_of(const FeatureCollection& collection) {
  const auto has = [&](const char* property) { return any_has(collection, property); };
  if (std::ranges::any_of(kUsual, has)) return {kUsual.begin(), kUsual.end()};
  const auto other = std::ranges::find_if(kOthers, has);
  return other == kOthers.end() ? std::vector<std::string>{} : std::vector<std::string>{*other};
}

bool is_like_level(const std::string& property) {
  const std::string name = lower_case_letters(property);
  return std::ranges::any_of(kLikeLevels, [&](const char* word) { return name.find(word) != std::string::npos; });
}

/// How often each value of the properties that are called like levels occurs among features that become map.
std::map<std::string, std::map<std::string, int>> values_like_levels(const FeatureCollection& collection) {
  std::map<std::string, std::map<std::string, int>> values;
  for (const Feature& feature : collection.features)
    for (auto property = feature.properties.begin(); feature.is_used && property != feature.properties.end();
         ++property)
      if (is_like_level(property.key()) && (property->is_string() || property->is_number()))
        ++values[property.key()][text_or_number(feature, property.key())];
  return values;
}

}  // namespace

void find_levels(const std::string& path, const std::string& property, FeatureCollection& collection) {
  if (!property.empty() && !any_has(collection, property))
    throw MapError(path + ": no feature has the property '" + property +
                   "', expected one that says levels, as the option level_property has it");
  const std::vector<std::string> properties =
      property.empty() ? properties_of(collection) : std::vector<std::string>{property};
  for (Feature& feature : collection.features) {
    for (const std::string& key : properties)
      if (feature.levels.empty()) add_property(feature, key, feature.levels);
    add_property(feature, "repeat_on", feature.levels);
    if (properties.size() == 1 && collection.level_property.empty())
      if (const auto found = find_property(feature, properties.front()); found != feature.properties.end())
        collection.level_property = found.key();
  }
}

std::vector<std::string> doubts_about_levels(const FeatureCollection& collection) {
  if (!all_levels(collection).empty()) return {};
  std::vector<std::string> doubts;
  for (const auto& [property, counts] : values_like_levels(collection)) {
    int features = 0;
    for (const auto& [value, count] : counts) features += count;
    if (counts.size() < 2 || 2 * static_cast<int>(counts.size()) > features) continue;  // areas and heights differ
    doubts.push_back(
        fmt::format("doubtful: '{0}' has {1} values, and all are in the map: if it says levels, "
                    "--set level_property={0}",
                    property, counts.size()));
  }
  return doubts;
}

bool is_on_level(const Feature& feature, const std::string& level) {
  const std::vector<std::string>& levels = feature.levels;
  const std::string wanted = number(level) ? written(*number(level)) : level;
  return levels.empty() || std::ranges::find(levels, wanted) != levels.end();
}

std::vector<std::string> all_levels(const FeatureCollection& collection) {
  return levels_where(collection, [](const Feature&) { return true; });
}

bool is_numbered(const std::string& level) { return number(level).has_value(); }

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
