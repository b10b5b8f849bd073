#include "map/view/tile_file.hpp"

#include "common/digest/sha256.hpp"
#include "common/whole_file.hpp"

#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>

#include <algorithm>
#include <cstring>

namespace opal {
namespace {

namespace bip = boost::interprocess;

constexpr std::size_t kSections = 6, kAlignment = 4096;
// To be raised when the same shapes are painted in another way: files of before then belong to no map.
constexpr int kPaintedAs = 1;

/// The first bytes of the file.
struct Header {
  std::array<char, 8> magic{'o', 'p', 'a', 'l', 't', 'i', 'l', 'e'};
  std::uint32_t version = 1, byte_order = 0x01020304;
  std::array<char, 64> digest{};
  std::array<std::int32_t, 2> layout{};           ///< columns and rows
  std::array<std::uint64_t, kSections> counts{};  ///< of values in each section
};
static_assert(std::is_trivially_copyable_v<Header>);

Header header_of(const std::string& digest, const TileLayout& layout) {
  Header header;
  std::copy_n(digest.begin(), std::min(digest.size(), header.digest.size()), header.digest.begin());
  header.layout = {layout.columns, layout.rows};
  return header;
}

std::size_t aligned(std::size_t bytes) { return (bytes + kAlignment - 1) / kAlignment * kAlignment; }

template <class T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

void write_padded(WholeFile& file, std::string_view bytes) {
  file.write(bytes);
  file.write(std::string(aligned(bytes.size()) - bytes.size(), '\0'));
}

/// Takes the sections of a mapped file one after the other.
class Sections {
 public:
  Sections(std::shared_ptr<const bip::mapped_region> region, const Header& header)
      : region_(std::move(region)), header_(header) {}

  template <class T>
  ReadOnlyArray<T> next() {
    const std::uint64_t count = header_.counts[section_++];
    if (count > region_->get_size() / sizeof(T) || at_ + count * sizeof(T) > region_->get_size()) {
      is_whole_ = false;
      return {};
    }
    const auto* values = reinterpret_cast<const T*>(static_cast<const char*>(region_->get_address()) + at_);
    at_ += aligned(count * sizeof(T));
    return ReadOnlyArray<T>(region_, {values, static_cast<std::size_t>(count)});
  }
  /// True if the file is as long as what was taken.
  bool is_whole() const { return is_whole_ && at_ == region_->get_size(); }

 private:
  std::shared_ptr<const bip::mapped_region> region_;
  const Header& header_;
  std::size_t section_ = 0, at_ = aligned(sizeof(Header));
  bool is_whole_ = true;
};

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
    digest.add(bytes_of(std::span<const double>(numbers)));
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

void write_tiles(const std::filesystem::path& file, const std::string& digest, const TileLayout& layout,
                 const SurfaceTiles& tiles) {
  Header header = header_of(digest, layout);
  header.counts = {tiles.tile_of.size(),  tiles.distances_cm.size(), tiles.coarse_cm.size(),
                   tiles.block_of.size(), tiles.blocks.size(),       tiles.names.size()};
  WholeFile whole(file.string());
  write_padded(whole, bytes_of(std::span<const Header>(&header, 1)));
  write_padded(whole, bytes_of(tiles.tile_of.values()));
  write_padded(whole, bytes_of(tiles.distances_cm.values()));
  write_padded(whole, bytes_of(tiles.coarse_cm.values()));
  write_padded(whole, bytes_of(tiles.block_of.values()));
  write_padded(whole, bytes_of(tiles.blocks.values()));
  write_padded(whole, bytes_of(tiles.names.values()));
  whole.finish();
}

std::optional<SurfaceTiles> read_tiles(const std::filesystem::path& file, const std::string& digest,
                                       const TileLayout& layout, int features) try {
  const bip::file_mapping mapping(file.c_str(), bip::read_only);
  auto region = std::make_shared<bip::mapped_region>(mapping, bip::read_only);
  if (region->get_size() < sizeof(Header)) return std::nullopt;
  Header found, expected = header_of(digest, layout);
  std::memcpy(&found, region->get_address(), sizeof(Header));
  expected.counts = found.counts;
  if (std::memcmp(&found, &expected, sizeof(Header)) != 0) return std::nullopt;
  Sections sections(region, found);
  SurfaceTiles tiles;
  tiles.tile_of = sections.next<std::uint32_t>();
  tiles.distances_cm = sections.next<SurfaceTile::Distances>();
  tiles.coarse_cm = sections.next<SurfaceTiles::CoarseDistances>();
  tiles.block_of = sections.next<SurfaceTiles::BlockNumbers>();
  tiles.blocks = sections.next<NearestBlock>();
  tiles.names = sections.next<MapFeatureNumber>();
  if (!sections.is_whole() || !stays_inside(tiles, layout, features)) return std::nullopt;
  region->advise(bip::mapped_region::advice_dontneed);  // what was only checked need not stay
  return tiles;
} catch (const bip::interprocess_exception&) {
  return std::nullopt;
}

}  // namespace opal
