#pragma once

#include "building.hpp"

namespace opal::ifc_importer {

/// Whether a name or a material speaks of glass that one looks through: by words that begin or end so ("glass",
/// "glazed", "Isolierglas"), and not if it speaks of what glass is a part of: wool, fibres, wallpaper, glazed tiles.
/// @param text  in lower case.
bool speaks_of_glass(const std::string& text);

/// Whether a thing is glass: its name or its type's name speaks of it, or its materials do. Of layers, glass must be
/// the most, without those of air. Of materials without a thickness, at least half must be glass; of a plate, which
/// fills a frame, one.
bool is_glass(const Element& element);

}  // namespace opal::ifc_importer
