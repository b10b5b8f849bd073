#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace opal::geojson_importer {

/// Reads text that holds one JSON value after another: each in a line of its own, or each behind a record separator
/// (RFC 8142), with line breaks inside or not. A value that is a FeatureCollection gives its features.
/// @param name   stands for the file in messages.
/// @param notes  gets sentences about what was found.
/// @return a FeatureCollection, in which a text that says the line stands for each value that is damaged; none: the
/// text is nothing of that kind.
std::optional<nlohmann::json> read_json_lines(std::string text, const std::string& name,
                                              std::vector<std::string>& notes);

}  // namespace opal::geojson_importer
