#include "json_lines.hpp"

#include <opal/common/file_start.hpp>
#include <opal/common/strict_json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace opal::geojson_importer {
namespace {

using nlohmann::json;

constexpr char kRecordSeparator = '\x1E';
constexpr std::string_view kBlank{" \t\r\n\0\x1E", 6};

struct Record {
  std::string text;
  int line = 0;  ///< in which it begins, from 1
};

/// What stands between separators and is not blank.
std::vector<Record> records_of(const std::string& text, char separator) {
  std::vector<Record> records;
  int line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    const std::string part = text.substr(at, end - at);
    const std::size_t first = part.find_first_not_of(kBlank);
    const auto breaks = [&](std::size_t until) {
      return static_cast<int>(std::count(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(until), '\n'));
    };
    if (first != std::string::npos)
      records.push_back({part.substr(first, part.find_last_not_of(kBlank) + 1 - first), line + breaks(first)});
    line += breaks(part.size()) + (separator == '\n' ? 1 : 0);
    at = end + 1;
  }
  return records;
}

std::optional<json> parsed(const std::string& text, const std::string& name) {
  try {
    return parse_json(text, name);
  } catch (const JsonError&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<json> read_json_lines(std::string text, const std::string& name, std::vector<std::string>& notes) {
  erase_byte_order_mark(text);
  const bool has_separators = text.find_first_not_of(" \t\r\n") == text.find(kRecordSeparator);
  const std::vector<Record> records = records_of(text, has_separators ? kRecordSeparator : '\n');
  if (records.empty() || (records.size() < 2 && !has_separators)) return std::nullopt;
  if (const auto first = parsed(records.front().text, name); !first || !first->is_object()) return std::nullopt;
  json features = json::array();
  std::vector<int> damaged;
  for (const Record& record : records) {
    std::optional<json> value = parsed(record.text, name);
    if (!value) damaged.push_back(record.line);
    const bool is_collection =
        value && value->is_object() && value->contains("features") && value->at("features").is_array();
    if (is_collection)
      std::move(value->at("features").begin(), value->at("features").end(), std::back_inserter(features));
    else
      features.push_back(value ? std::move(*value) : json(fmt::format("line {}: no JSON", record.line)));
  }
  notes.push_back(fmt::format("features one by one, {}: {}",
                              has_separators ? "behind record separators (RFC 8142)" : "each in a line of its own",
                              features.size()));
  if (!damaged.empty())
    notes.push_back(
        fmt::format("doubtful: lines that are no JSON, so that what they hold is missing: {}, the first is line {}",
                    damaged.size(), damaged.front()));
  return json{{"type", "FeatureCollection"}, {"features", std::move(features)}};
}

}  // namespace opal::geojson_importer
