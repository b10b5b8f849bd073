#include "level.hpp"

#include <algorithm>
#include <charconv>
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
    for (double level = *from; level <= *to; ++level) levels.push_back(written(level));
  else if (!part.empty())
    levels.push_back(part);
}

}  // namespace

std::vector<std::string> levels_of(const Feature& feature) {
  std::vector<std::string> levels;
  for (const char* key : {"level", "level_id"}) {
    if (!levels.empty() || !feature.properties.contains(key)) continue;
    const nlohmann::json& value = feature.properties.at(key);
    std::istringstream parts(value.is_string() ? value.get<std::string>() : value.is_number() ? value.dump() : "");
    for (std::string part; std::getline(parts, part, ';');) {
      part.erase(0, part.find_first_not_of(' '));
      add_levels(part, levels);
    }
  }
  return levels;
}

bool is_on_level(const Feature& feature, const std::string& level) {
  const std::vector<std::string> levels = levels_of(feature);
  const std::string wanted = number(level) ? written(*number(level)) : level;
  return levels.empty() || std::find(levels.begin(), levels.end(), wanted) != levels.end();
}

std::vector<std::string> all_levels(const FeatureCollection& collection) {
  std::set<std::pair<double, std::string>> levels;
  for (const Feature& feature : collection.features)
    for (const std::string& level : levels_of(feature)) levels.emplace(number(level).value_or(1e9), level);
  std::vector<std::string> names;
  for (const auto& [height, name] : levels) names.push_back(name);
  return names;
}

}  // namespace opal::geojson_importer
