#pragma once

#include <opal/map/map_importer.hpp>

#include <algorithm>
#include <string>

namespace opal {

/// Whether a sentence of the report has these words.
inline bool says(const MapImport& imported, const std::string& words) {
  return std::ranges::any_of(imported.report,
                             [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

}  // namespace opal
