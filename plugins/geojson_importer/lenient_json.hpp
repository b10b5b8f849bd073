#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace opal::geojson_importer {

/// Reads JSON strictly, but for NaN and Infinity in the place of a number, which some programs write: these become
/// marked texts, which take_no_number() finds. Text of one value after another becomes a FeatureCollection.
/// @param notes  gets a sentence about them.
/// @throws MapError "PATH: where: what was found, what was expected".
nlohmann::json read_lenient_json(const std::string& path, std::vector<std::string>& notes);

/// Takes the marks off the texts in a value that stand for NaN and Infinity.
/// @return "/properties/height: NaN" of the first one; empty if there is none.
std::string take_no_number(nlohmann::json& value);

}  // namespace opal::geojson_importer
