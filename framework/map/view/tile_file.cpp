#include "map/view/tile_file.hpp"

#include "common/digest/sha256.hpp"
#include "common/prepared/section_file.hpp"

#include <algorithm>

namespace opal {
namespace {

// To be raised when the same shapes are painted in another way: files of before then belong to no map.
constexpr int kPaintedAs = 1;

SectionKey key_of(const std::string& digest) { return {{'t', 'i', 'l', 'e', 's'}, digest}; }

/// Whoever follows a number in the tiles stays within them.
bool stays_inside(const SurfaceTiles& tiles, const TileLayout& layout, int features) {
  const auto below = [](std::size_t end) { return [end](std::uint32_t number) { return number < end; }; };
  const std::size_t count = tiles.distances_cm.size();
  const auto tile_of = tiles.tile_of.values();
  const auto block_of = tiles.block_of.values();
  const auto blocks = tiles.blocks.values();
  const auto names = tiles.names.values();
  return tile_of.size() == layout.tiles() && count > 0 && tiles.coarse_cm.size() == count && block_of.size() == count &&
         !blocks.empty() && std::all_of(tile_of.begin(), tile_of.end(), below(count)) &&
         std::all_of(
             block_of.begin(), block_of.end(),
             [&](const auto& numbers) { return std::all_of(numbers.begin(), numbers.end(), below(blocks.size())); }) &&
         std::all_of(blocks.begin(), blocks.end(),
                     [&](const NearestBlock& block) {
                       std::uint8_t last = 0;
                       for (const auto& [first, second] : block.position) last = std::max({last, first, second});
                       return std::size_t{block.list_begin} + last < names.size();
                     }) &&
         std::all_of(names.begin(), names.end(),
                     [&](MapFeatureNumber name) { return name.number() >= -1 && name.number() < features; });
}

}  // namespace

std::string digest_of(const TileLayout& layout, const std::vector<NumberedShape>& shapes) {
  Sha256 digest;
  const auto add = [&](auto... values) {
    const std::array<double, sizeof...(values)> numbers{static_cast<double>(values)...};
    digest.add(Section(std::span<const double>(numbers)).bytes);
  };
  add(kPaintedAs, SurfaceTile::kCell_m, SurfaceTile::kReach_m, SurfaceTile::kCap_m, SurfaceTiles::kCoarse);
  add(layout.low.x(), layout.low.y(), layout.columns, layout.rows);
  for (const auto& [number, shape] : shapes) {
    add(number.number(), shape.index());
    if (const auto* segment = std::get_if<Segment>(&shape))
      add(segment->begin.x(), segment->begin.y(), segment->end.x(), segment->end.y());
    if (const auto* circle = std::get_if<Circle>(&shape)) add(circle->center.x(), circle->center.y(), circle->radius_m);
  }
  return digest.finish();
}

void write_tiles(const std::filesystem::path& file, const std::string& digest, const SurfaceTiles& tiles) {
  const std::array sections{Section(tiles.tile_of),  Section(tiles.distances_cm), Section(tiles.coarse_cm),
                            Section(tiles.block_of), Section(tiles.blocks),       Section(tiles.names)};
  write_sections(file, key_of(digest), sections);
}

std::optional<SurfaceTiles> read_tiles(const std::filesystem::path& file, const std::string& digest,
                                       const TileLayout& layout, int features) {
  std::optional<Sections> sections = Sections::open(file, key_of(digest));
  if (!sections) return std::nullopt;
  SurfaceTiles tiles;
  tiles.tile_of = sections->next<std::uint32_t>();
  tiles.distances_cm = sections->next<SurfaceTile::Distances>();
  tiles.coarse_cm = sections->next<SurfaceTiles::CoarseDistances>();
  tiles.block_of = sections->next<SurfaceTiles::BlockNumbers>();
  tiles.blocks = sections->next<NearestBlock>();
  tiles.names = sections->next<MapFeatureNumber>();
  if (!sections->are_whole() || !stays_inside(tiles, layout, features)) return std::nullopt;
  sections->let_go();
  return tiles;
}

}  // namespace opal
