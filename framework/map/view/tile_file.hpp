#pragma once

#include "map/view/surface_tiles.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace opal {

/// What the tiles of a map depend on: how they are painted, layout, shapes and their numbers, as 64 hexadecimal digits.
OPAL_EXPORT std::string digest_of(const TileLayout& layout, const std::vector<NumberedShape>& shapes);

/// A file that is mapped into memory where it is read: what nobody looks at takes none. It is of this kind of machine.
/// @throws WriteError. The file is there when it is whole.
OPAL_EXPORT void write_tiles(const std::filesystem::path& file, const std::string& digest, const SurfaceTiles& tiles);

/// @param digest  that the file must have.
/// @param features  every number in the file must be less.
/// @return nothing if there is no such file, or it is not whole, or of another map, program or kind of machine.
OPAL_EXPORT std::optional<SurfaceTiles> read_tiles(const std::filesystem::path& file, const std::string& digest,
                                                   const TileLayout& layout, int features);

}  // namespace opal
