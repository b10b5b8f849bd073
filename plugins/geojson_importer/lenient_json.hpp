#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace opal::geojson_importer {

/// Reads JSON strictly, but for NaN and Infinity in the place of a number, which some programs write: these become
/// texts. A text is no coordinate and no length, so nothing of a map is made of it.
/// @param notes  gets a sentence about them.
/// @throws MapError "PATH: where: what was found, what was expected".
nlohmann::json read_lenient_json(const std::string& path, std::vector<std::string>& notes);

}  // namespace opal::geojson_importer
