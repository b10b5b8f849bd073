#include "map/view/tile_file.hpp"
#include "map/view/surface_grid.hpp"
#include "map/view/tile_cache.hpp"
#include "walls.hpp"

#include "tests/kit/damaged_bytes.hpp"
#include "tests/kit/file_content.hpp"
#include "tests/kit/same_bytes.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <opal/map/view/map_view.hpp>

#include <filesystem>
#include <thread>

using namespace opal;
namespace fs = std::filesystem;

namespace {

constexpr double kSide_m = 60;

/// Shapes with what a program makes of them.
struct Painted {
  explicit Painted(const std::vector<Geometry>& geometries) {
    for (std::size_t k = 0; k < geometries.size(); ++k) shapes.emplace_back(MapFeatureNumber(k), geometries[k]);
    digest = digest_of(layout, shapes);
  }
  int features() const { return static_cast<int>(shapes.size()); }
  SurfaceTiles painted() const { return opal::painted(layout, shapes); }
  std::optional<SurfaceTiles> read(const fs::path& file) const { return read_tiles(file, digest, layout, features()); }

  TileLayout layout = TileLayout::around({0, 0}, {kSide_m, kSide_m});
  std::vector<NumberedShape> shapes;
  std::string digest;
};

Painted some_walls(unsigned seed = 1) {
  std::vector<Geometry> geometries = random_walls(60, seed);
  geometries.push_back(Circle{{20, 20}, 0.4});
  return Painted(geometries);
}

/// A cache for which some walls are many.
TileCache cache_in(const std::string& folder) { return TileCache(folder, 50); }

/// The tiles of a map in a file.
struct Written {
  Written() {
    write_tiles(file, map.digest, map.painted());
    whole = content_of(file);
  }
  TemporaryFolder folder;
  Painted map = some_walls();
  fs::path file = folder.path_of("map.tiles");
  std::string whole;  ///< its bytes
};

bool same(const SurfaceTiles& a, const SurfaceTiles& b) {
  return same_bytes(a.tile_of, b.tile_of) && same_bytes(a.distances_cm, b.distances_cm) &&
         same_bytes(a.coarse_cm, b.coarse_cm) && same_bytes(a.block_of, b.block_of) && same_bytes(a.blocks, b.blocks) &&
         same_bytes(a.names, b.names);
}

/// Asks every cell, so that a number that leads outside is noticed.
void ask_everywhere(const Painted& map, const SurfaceTiles& tiles) {
  const SurfaceGrid grid(map.layout, tiles);
  for (double x = -3; x < kSide_m + 3; x += 0.4)
    for (double y = -3; y < kSide_m + 3; y += 0.4)
      for (const MapFeatureNumber name : grid.nearest({x, y}))
        if (name.number() >= map.features()) FAIL("no such feature: " << name);
}

}  // namespace

TEST_CASE("tiles that were written are read as they were") {
  const TemporaryFolder folder;
  const Painted map = some_walls(GENERATE(1u, 2u, 3u));
  const fs::path file = folder.path_of("map.tiles");
  write_tiles(file, map.digest, map.painted());
  const auto read = map.read(file);
  REQUIRE(read);
  CHECK(same(*read, map.painted()));
}

TEST_CASE("tiles outlive their file") {
  const Painted map = some_walls();
  std::optional<SurfaceTiles> read;
  {
    const TemporaryFolder folder;
    write_tiles(folder.path_of("map.tiles"), map.digest, map.painted());
    read = map.read(folder.path_of("map.tiles"));
  }
  REQUIRE(read);
  CHECK(same(*read, map.painted()));
}

TEST_CASE("whatever changes the tiles changes the digest") {
  const Painted map = some_walls();
  Painted moved = map, renumbered = map, wider = map;
  std::get<Segment>(moved.shapes[7].second).end.x() += 1e-9;
  std::swap(renumbered.shapes[0].first, renumbered.shapes[1].first);
  wider.layout.columns += 1;
  for (const Painted* other : {&moved, &renumbered, &wider})
    CHECK(digest_of(other->layout, other->shapes) != map.digest);
  CHECK(digest_of(map.layout, map.shapes) == map.digest);
}

TEST_CASE("a file that is not there, or of another map, gives nothing") {
  const TemporaryFolder folder;
  const Painted map = some_walls(1), other = some_walls(2);
  const fs::path file = folder.path_of("map.tiles");
  CHECK_FALSE(map.read(file));
  write_tiles(file, map.digest, map.painted());
  CHECK_FALSE(other.read(file));
  TileLayout shorter = map.layout;
  --shorter.rows;
  CHECK_FALSE(read_tiles(file, map.digest, shorter, map.features()));
  CHECK_FALSE(read_tiles(file, map.digest, map.layout, 3));  // it names features that the map does not have
  CHECK_FALSE(map.read(folder.path()));
}

TEST_CASE("a file that is cut or grown gives nothing") {
  const Written written;
  for (const std::string& other : cut_or_grown(written.whole)) {
    CAPTURE(other.size());
    write_bytes(written.file, other);
    CHECK_FALSE(written.map.read(written.file));
  }
}

TEST_CASE("a file with wrong bytes gives nothing, or tiles that lead nowhere outside") {
  const Written written;
  const Painted& map = written.map;
  int refused = 0;
  for (const std::string& wrong : with_wrong_bytes(written.whole, 30)) {
    write_bytes(written.file, wrong);
    if (const auto read = map.read(written.file))
      ask_everywhere(map, *read);
    else
      ++refused;
  }
  CHECK(refused >= 12);
}

TEST_CASE("the tiles of a large map are kept in one file, and come from there the next time") {
  const TemporaryFolder folder;
  const Painted map = some_walls();
  const TileCache cache = cache_in(folder.path_of("prepared"));
  const SurfaceTiles first = cache.tiles_of(map.layout, map.shapes, map.features());
  CHECK(same(first, map.painted()));
  const auto files = files_in(folder.path_of("prepared"));
  REQUIRE(files.size() == 1);
  const std::string kept = content_of(files[0]);
  CHECK(same(cache.tiles_of(map.layout, map.shapes, map.features()), first));
  CHECK(files_in(folder.path_of("prepared")) == files);
  CHECK(content_of(files[0]) == kept);
}

TEST_CASE("a damaged file is made again") {
  const TemporaryFolder folder;
  const Painted map = some_walls();
  const TileCache cache = cache_in(folder.path());
  cache.tiles_of(map.layout, map.shapes, map.features());
  const fs::path file = files_in(folder.path()).at(0);
  const std::string kept = content_of(file);
  write_bytes(file, "no tiles");
  CHECK(same(cache.tiles_of(map.layout, map.shapes, map.features()), map.painted()));
  CHECK(content_of(file) == kept);
}

TEST_CASE("small maps, and whoever names no folder, keep nothing") {
  const TemporaryFolder folder;
  const Painted map = some_walls();
  CHECK(same(TileCache(folder.path()).tiles_of(map.layout, map.shapes, map.features()), map.painted()));
  CHECK(same(cache_in({}).tiles_of(map.layout, map.shapes, map.features()), map.painted()));
  CHECK(files_in(folder.path()).empty());
}

TEST_CASE("where nothing can be written, tiles are painted") {
  const TemporaryFolder folder;
  const Painted map = some_walls();
  write_bytes(folder.path_of("in_the_way"), "a file");
  const TileCache cache = cache_in(folder.path_of("in_the_way") + "/prepared");
  CHECK(same(cache.tiles_of(map.layout, map.shapes, map.features()), map.painted()));
}

TEST_CASE("programs that keep the same map at once all have it") {
  const TemporaryFolder folder;
  const Painted map = some_walls();
  const SurfaceTiles expected = map.painted();
  std::array<bool, 4> right{};
  std::vector<std::thread> programs;
  for (bool& is_right : right)
    programs.emplace_back(
        [&] { is_right = same(cache_in(folder.path()).tiles_of(map.layout, map.shapes, map.features()), expected); });
  for (std::thread& program : programs) program.join();
  CHECK(right == std::array{true, true, true, true});
  CHECK(files_in(folder.path()).size() == 1);
}

TEST_CASE("files that nobody has used for a month go away, others stay") {
  const TemporaryFolder folder;
  const auto month_ago = fs::file_time_type::clock::now() - std::chrono::hours(24 * 31);
  for (const char* name : {"old.tiles", "new.tiles", "old.txt"}) write_bytes(folder.path_of(name), "x");
  for (const char* name : {"old.tiles", "old.txt"}) fs::last_write_time(folder.path_of(name), month_ago);
  const Painted map = some_walls();
  cache_in(folder.path()).tiles_of(map.layout, map.shapes, map.features());
  CHECK_FALSE(fs::exists(folder.path_of("old.tiles")));
  CHECK(fs::exists(folder.path_of("new.tiles")));
  CHECK(fs::exists(folder.path_of("old.txt")));
}

TEST_CASE("a view of a large map answers the same from a file") {
  const TemporaryFolder folder;
  std::vector<Geometry> geometries;
  for (double x = 0; geometries.size() < TileCache::kLargeMap; x += 0.2)
    for (double y = 0; y < 20; y += 0.2) geometries.push_back(Segment{{x, y}, {x + 0.05, y + 0.02}});
  const auto map = map_of(geometries);
  const MapView painted(map, "PlanarLidar2D");
  CHECK(files_in(folder.path()).empty());
  const MapView written(map, "PlanarLidar2D", folder.path()), read(map, "PlanarLidar2D", folder.path());
  CHECK(files_in(folder.path()).size() == 1);
  for (const MapView* kept : {&written, &read})
    for (double x = 0.05; x < 20; x += 1.7)
      for (double y = 0.05; y < 20; y += 1.3) {
        CHECK(kept->clearance_m({x, y}) == painted.clearance_m({x, y}));
        CHECK(kept->nearest_facing({x, y}, {1, 0}) == painted.nearest_facing({x, y}, {1, 0}));
      }
}
