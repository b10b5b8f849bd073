#pragma once

#include <optional>
#include <string>

namespace opal::dxf_importer {

/// What the words of a layer's name say in the languages of those who draw: "0_MURATURE", "Стены", "外壁". An object
/// type; nothing if no word is known.
std::optional<std::string> class_by_words(const std::string& layer);

/// Whether a word says that the layer is no part of the plan, whatever stands beside it: dimensions, axes, elevations,
/// furniture, what is to be demolished.
bool has_word_of_no_part(const std::string& layer);

}  // namespace opal::dxf_importer
