#include "whole_import.hpp"

#include "tests/kit/file_content.hpp"

#include <algorithm>
#include <regex>
#include <set>

namespace {

/// Nothing that is said to be imported is missing on the map, and nothing is on the map that no line of the report
/// knows.
std::string contradiction(const opal::MapImport& imported) {
  std::set<std::string> objects, reported;
  for (const opal::MapObject& object : imported.map->objects()) objects.insert(object.id);
  for (const opal::ImportedElement& element : imported.elements) {
    if (element.status == opal::ImportStatus::imported && !objects.contains(element.id))
      return element.id + " is imported, but is not on the map";
    if (element.status != opal::ImportStatus::imported && element.reason.empty())
      return element.id + " is not imported, and nothing says why";
    reported.insert(element.id);
  }
  for (const std::string& object : objects)
    if (!reported.contains(object)) return object + " is on the map, but not in the report";
  return "";
}

std::vector<std::string> trimmed_lines(const std::string& text) {
  std::vector<std::string> lines = opal::lines_of(text);
  for (std::string& line : lines) {
    line.erase(0, line.find_first_not_of(" \t\r"));
    line.erase(line.find_last_not_of(" \t\r") + 1);
  }
  return lines;
}

/// Of text in UTF-16 the letters of ASCII.
std::string narrow(std::string text) {
  const bool has_mark = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  if (has_mark) text.erase(0, 2);
  if (has_mark || text.substr(0, 2).find('\0') != std::string::npos) std::erase(text, '\0');
  return text;
}

bool is_geometry(const nlohmann::json& type) { return type == "LineSegment" || type == "Circle" || type == "Corner"; }

int geometries(const nlohmann::json& json) {
  int count = json.is_object() && json.contains("@type") && is_geometry(json.at("@type"));
  if (json.is_structured())
    for (const auto& part : json) count += geometries(part);
  return count;
}

}  // namespace

std::string whole_dxf(const opal::MapImport& imported, const std::string& text) {
  const std::vector<std::string> lines = trimmed_lines(narrow(text));
  const auto last = std::find_if(lines.rbegin(), lines.rend(), [](const std::string& line) { return !line.empty(); });
  if (last == lines.rend() || *last != "EOF") return "the file does not end with EOF";
  std::size_t entities = 0;
  bool is_inside = false;
  for (std::size_t k = 0; k + 1 < lines.size(); k += 2) {
    if (lines[k] == "2" && k >= 2 && lines[k - 1] == "SECTION") is_inside = lines[k + 1] == "ENTITIES";
    const std::string& type = lines[k + 1];
    const bool is_part = type == "VERTEX" || type == "SEQEND" || type == "ATTRIB" || type == "ENDSEC" ||
                         type == "SECTION" || type == "EOF";
    entities += is_inside && lines[k] == "0" && !is_part;
  }
  if (imported.elements.size() < entities)
    return "the report knows " + std::to_string(imported.elements.size()) + " things of " + std::to_string(entities);
  return contradiction(imported);
}

std::string whole_geojson(const opal::MapImport& imported, const std::string& text) {
  static const std::regex kNoNumber(R"(([:,[]\s*)-?(NaN|nan|inf|Infinity)\b)");  // of features without a class
  const auto json = nlohmann::json::parse(std::regex_replace(text, kNoNumber, "$1null"));
  const std::size_t features = json.contains("features") ? json.at("features").size() : 1;
  if (imported.elements.size() != features)
    return "the report knows " + std::to_string(imported.elements.size()) + " things of " + std::to_string(features);
  return contradiction(imported);
}

std::string whole_map(const opal::SemanticMap& map, const std::string& text) {
  const int written = geometries(nlohmann::json::parse(text));
  const int kept = geometries(map.to_json_ld());
  return kept >= written ? "" : "the map holds " + std::to_string(kept) + " geometries of " + std::to_string(written);
}

std::string whole_ifc(const opal::MapImport& imported, const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos || !std::string_view(text).substr(0, end + 1).ends_with("END-ISO-10303-21;")) {
    const bool is_told = std::ranges::any_of(
        imported.report, [](const std::string& sentence) { return sentence.starts_with("doubtful: the file "); });
    return is_told ? contradiction(imported) : "the file does not end as it should, and nobody is told";
  }
  static const std::regex kElement(R"(#\d+\s*=\s*IFC(WALL|WALLSTANDARDCASE|COLUMN|DOOR|WINDOW)\s*\()");
  const auto things = std::distance(std::sregex_iterator(text.begin(), text.end(), kElement), std::sregex_iterator());
  if (std::ssize(imported.elements) < things)
    return "the report knows " + std::to_string(imported.elements.size()) + " things of " + std::to_string(things);
  return contradiction(imported);
}
