// What map_server yaml files and images mean, and what is wrong with bad ones.
#include "drawn_grid.hpp"

#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <limits>
#include <numbers>

namespace {

using namespace opal;
using namespace opal::test;
using Catch::Matchers::Contains;

DrawnGrid room() { return DrawnGrid(60, 50).room(10, 10, 49, 39); }

/// Imports yaml text beside an image "room.pgm".
MapImport import_yaml(const std::string& yaml, const std::string& image_bytes = room().pgm()) {
  const TemporaryFolder folder;
  folder.write("room.pgm", image_bytes);
  return grid_importer()->import(folder.write("room.yaml", yaml));
}

std::string message_of(const std::string& yaml, const std::string& image_bytes = room().pgm()) {
  return refused_with<MapError>([&] { import_yaml(yaml, image_bytes); });
}

bool same_geometry(const SemanticMap& a, const SemanticMap& b) {
  return a.to_json_ld().dump() == b.to_json_ld().dump();
}

/// Every pixel changed by a function.
template <class Change>
std::string pgm_with(const DrawnGrid& grid, Change change) {
  DrawnGrid changed = grid;
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column) changed.at(column, row) = change(grid.at(column, row));
  return changed.pgm();
}

std::string plain_pgm(const DrawnGrid& grid) {
  std::string text = "P2 # plain\n" + std::to_string(grid.columns()) + " " + std::to_string(grid.rows()) + " 255\n";
  for (int row = grid.rows() - 1; row >= 0; --row)
    for (int column = 0; column < grid.columns(); ++column) text += std::to_string(grid.at(column, row)) + "\n";
  return text;
}

std::string wide_pgm(const DrawnGrid& grid) {
  std::string bytes = "P5 " + std::to_string(grid.columns()) + " " + std::to_string(grid.rows()) + " 65535\n";
  for (int row = grid.rows() - 1; row >= 0; --row)
    for (int column = 0; column < grid.columns(); ++column)
      bytes += std::string(2, static_cast<char>(grid.at(column, row)));
  return bytes;
}

}  // namespace

TEST_CASE("the same picture as raw, plain, 16-bit PGM and PNG is the same map") {
  const auto map = import_yaml(yaml_for("room.pgm")).map;
  REQUIRE(all<Segment>(*map).size() == 4);
  CHECK(same_geometry(*map, *import_yaml(yaml_for("room.pgm"), plain_pgm(room())).map));
  CHECK(same_geometry(*map, *import_yaml(yaml_for("room.pgm"), wide_pgm(room())).map));
  CHECK(same_geometry(*map, *import_yaml(yaml_for("room.pgm"), room().png()).map));
}

TEST_CASE("negate swaps bright and dark") {
  const auto map = import_yaml(yaml_for("room.pgm")).map;
  const auto inverse = pgm_with(room(), [](std::uint8_t shade) { return static_cast<std::uint8_t>(255 - shade); });
  CHECK(same_geometry(*map, *import_yaml(yaml_for("room.pgm", "[0, 0, 0]", "negate: 1\n"), inverse).map));
  CHECK_FALSE(same_geometry(*map, *import_yaml(yaml_for("room.pgm"), inverse).map));
}

TEST_CASE("thresholds say what is occupied and free") {
  const auto map = import_yaml(yaml_for("room.pgm")).map;
  const auto faint = pgm_with(room(), [](std::uint8_t shade) {
    return static_cast<std::uint8_t>(shade == DrawnGrid::kOccupied ? 120 : shade);  // occupied with 0.53
  });
  CHECK_THROWS_WITH(
      import_yaml(yaml_for("room.pgm"), faint),
      Contains("0 cells are occupied and") && Contains("expected a building: mode, negate and the thresholds"));
  CHECK(same_geometry(*map, *import_yaml(yaml_for("room.pgm", "[0, 0, 0]", "occupied_thresh: 0.5\n"), faint).map));
}

TEST_CASE("scale mode reads like trinary where pixels are sure") {
  const auto map = import_yaml(yaml_for("room.pgm")).map;
  CHECK(same_geometry(*map, *import_yaml(yaml_for("room.pgm", "[0, 0, 0]", "mode: scale\n")).map));
}

TEST_CASE("raw mode takes the byte as percent, and above 100 as unknown") {
  const auto map = import_yaml(yaml_for("room.pgm")).map;
  const auto percent = pgm_with(room(), [](std::uint8_t shade) -> std::uint8_t {
    return shade == DrawnGrid::kOccupied ? 100 : shade == DrawnGrid::kFree ? 0 : 255;
  });
  CHECK(same_geometry(*map, *import_yaml(yaml_for("room.pgm", "[0, 0, 0]", "mode: raw\nnegate: 1\n"), percent).map));
}

TEST_CASE("the origin moves and turns the map") {
  const auto map = import_yaml(yaml_for("room.pgm")).map;
  const auto moved = import_yaml(yaml_for("room.pgm", "[-3.5, 12, 0.5]")).map;
  const Pose2 T_moved_map(-3.5, 12, 0.5);
  REQUIRE(moved->features().size() == map->features().size());
  for (std::size_t k = 0; k < map->features().size(); ++k) {
    const Geometry expected = transformed(T_moved_map, map->features()[k].geometry);
    CAPTURE(map->features()[k].id);
    CHECK((anchor_of(moved->features()[k].geometry) - anchor_of(expected)).norm() < 1e-9);
  }
  CHECK(all<OrientedPoint>(*moved)[0].heading_rad ==
        Approx(wrap_angle(all<OrientedPoint>(*map)[0].heading_rad + 0.5)).margin(1e-9));
}

TEST_CASE("a map is called after its file, and keys that map_server does not know are reported") {
  const MapImport imported = import_yaml(yaml_for("room.pgm", "[0, 0, 0]", "author: somebody\n"));
  CHECK(imported.map->name() == "room");
  CHECK(imported.report.back() == "ignored in the yaml file: \"author\", which map_server does not define");
}

TEST_CASE("the report says what was found and what was left out") {
  const auto report = import_yaml(yaml_for("room.pgm")).report;
  REQUIRE(report.size() == 7);
  CHECK(report[0] == "grid of 60 x 50 cells of 0.05 m: 136 occupied, 1064 free (3 m2)");
  CHECK(report[1] == "4 wall faces, 7 m: 0 of at least 5 m, 4 of 1 to 5 m, 0 shorter");
  CHECK(report[2] == "4 corners: 0 convex, 4 concave; 0 round columns");
  CHECK_THAT(report[3], Contains("left out: 0 of 136 boundary cells"));
  CHECK_THAT(report[4], Contains("boundary cells lie 0.000 m"));
  CHECK_THAT(report[5], Contains("0.05 m of occupied cells thick"));
  CHECK(report[6] == "a drawn plan: 4 faces run along its rows and columns as they are drawn");
}

TEST_CASE("the importer recognizes map_server yaml files, and nothing else") {
  const TemporaryFolder folder;
  const auto importer = grid_importer();
  CHECK(importer->recognizes(folder.write("a.yaml", yaml_for("a.pgm"))));
  CHECK(importer->recognizes(folder.write("A.YAML", yaml_for("a.pgm"))));
  CHECK(importer->recognizes(folder.write("A.Yml", yaml_for("a.pgm"))));
  CHECK_FALSE(importer->recognizes(folder.write("b.yaml", "topics: [scan]\n")));
  CHECK_FALSE(importer->recognizes(folder.write("c.pgm", room().pgm())));
  CHECK_FALSE(importer->recognizes(folder.path() + "/missing.yaml"));
  CHECK_FALSE(importer->recognizes(folder.path()));
}

TEST_CASE("thresholds that are exchanged leave nothing unknown, which is told") {
  const std::string start = "image: room.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n";
  const MapImport exchanged = import_yaml(start + "occupied_thresh: 0.65\nfree_thresh: 0.9\n");
  CHECK(exchanged.report.back() ==
        "doubtful: free_thresh 0.9 lies above occupied_thresh 0.65: cells up to occupied_thresh are free, all others "
        "occupied");
  const MapImport usual = import_yaml(start + "occupied_thresh: 0.65\nfree_thresh: 0.65\n");
  CHECK(same_geometry(*exchanged.map, *usual.map));
  CHECK_THAT(usual.report.back(), !Contains("doubtful"));
}

TEST_CASE("what map_saver wrote as unknown stays unknown when its threshold would make it free, which is told") {
  const std::string start =
      "image: room.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nmode: trinary\noccupied_thresh: 0.65\n";
  const MapImport usual = import_yaml(start + "free_thresh: 0.196\n");
  const MapImport saved = import_yaml(start + "free_thresh: 0.25\n");
  CHECK(same_geometry(*saved.map, *usual.map));
  CHECK_THAT(saved.report.back(),
             Contains("free_thresh 0.25 would make the cells free that map_saver wrote as unknown"));
  CHECK_THAT(usual.report.back(), !Contains("map_saver"));
  const std::string retouched =
      pgm_with(room(), [](std::uint8_t grey) -> std::uint8_t { return grey == 0 ? 40 : grey; });
  CHECK_THAT(import_yaml(start + "free_thresh: 0.25\n", retouched).report.back(), !Contains("map_saver"));
}

TEST_CASE("negate takes the booleans of YAML") {
  const std::string start = "image: room.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: ";
  const auto with = [&](const char* word) { return import_yaml(start + word).map; };
  for (const char* no : {"false", "FALSE", "no", "No", "off"}) {
    CAPTURE(no);
    CHECK(same_geometry(*with(no), *with("0")));
  }
  for (const char* yes : {"true", "TRUE", "yes", "Yes", "on"}) {
    CAPTURE(yes);
    CHECK(same_geometry(*with(yes), *with("1")));
  }
  CHECK_FALSE(same_geometry(*with("0"), *with("1")));
}

TEST_CASE("a key that map_server does not define may be there twice, and is told once") {
  const MapImport imported =
      import_yaml("image: room.pgm\nresolution: 0.05\norigin: [0, 0, 0]\ncomment: a\ncomment: b\n");
  CHECK(std::count(imported.report.begin(), imported.report.end(),
                   "ignored in the yaml file: \"comment\", which map_server does not define") == 1);
}

TEST_CASE("a bad yaml file is refused with its line, the key, what was found and what was expected") {
  const std::string start = "image: room.pgm\n";
  const std::string rest = "resolution: 0.05\norigin: [0, 0, 0]\n";
  CHECK_THAT(message_of(start + "resolution: 0\norigin: [0, 0, 0]\n"),
             Contains("room.yaml: line 2: resolution: 0, expected a cell size from 0.001 to 10 m"));
  CHECK_THAT(message_of(start + "resolution: fine\norigin: [0, 0, 0]\n"), Contains("line 2: resolution: fine"));
  CHECK_THAT(message_of(start + "resolution: -0.05\norigin: [0, 0, 0]\n"), Contains("line 2: resolution: -0.05"));
  CHECK_THAT(message_of(start + "resolution: .inf\norigin: [0, 0, 0]\n"), Contains("line 2: resolution: .inf"));
  CHECK_THAT(message_of(start + "resolution: 0.05\norigin: [0, .nan, 0]\n"),
             Contains("line 3: origin: [0, .nan, 0], expected [x, y, yaw], three finite numbers"));
  CHECK_THAT(message_of(start + "resolution: 0.05\norigin: [0, 0]\n"), Contains("line 3: origin"));
  CHECK_THAT(message_of(start + "resolution: 0.05\norigin: [1e30, 0, 0]\n"), Contains("line 3: origin"));
  CHECK_THAT(message_of(start + rest + "mode: colour\n"), Contains("mode: colour, expected trinary, scale or raw"));
  CHECK_THAT(message_of(start + rest + "negate: 2\n"), Contains("negate: 2, expected 0 or 1"));
  CHECK_THAT(message_of(start + rest + "free_thresh: 1.5\n"),
             Contains("free_thresh: 1.5, expected a number from 0 to 1"));
  CHECK_THAT(message_of(start + rest + start), Contains("line 4: image: room.pgm, expected this key only once"));
  CHECK_THAT(message_of(start + "origin: [0, 0, 0]\n"), Contains("room.yaml: resolution is missing"));
  CHECK_THAT(message_of("image: [\n"), Contains("room.yaml: line 2: not valid YAML"));
  CHECK_THAT(message_of("image: [a]\n" + rest), Contains("line 1: image"));
  CHECK_THAT(message_of(""), Contains("room.yaml: line 1: expected \"key: value\" lines"));
  CHECK_THAT(message_of("- a\n- b\n"), Contains("room.yaml: line 1: expected \"key: value\" lines"));
  CHECK_THAT(message_of(std::string(100000, '[')), Contains("room.yaml: 100000 bytes"));
  CHECK_THAT(message_of(std::string(60000, '[')), Contains("room.yaml: line 1: not valid YAML"));
}

TEST_CASE("a bad image is refused with its name, the place, what was found and what was expected") {
  const std::string yaml = yaml_for("room.pgm");
  const std::string good = room().pgm();
  CHECK_THAT(message_of(yaml, good.substr(0, good.size() - 7)),
             Contains("room.pgm: byte 31: 2993 bytes of pixels until the end of the file, expected 3000 for 60 x 50"));
  CHECK_THAT(message_of(yaml, "P5 60"), Contains("room.pgm: byte 5: end of file, expected the height"));
  CHECK_THAT(message_of(yaml, "P5 sixty"), Contains("room.pgm: byte 3: no number, expected the width"));
  CHECK_THAT(message_of(yaml, "P5 4000000000 4000000000 255\n"),
             Contains("room.pgm: header: 4000000000 x 4000000000 pixels"));
  CHECK_THAT(message_of(yaml, "P5 99999999999999999999 2 255\n"), Contains("a number above 2^32, expected the width"));
  CHECK_THAT(message_of(yaml, "P5 0 2 255\n"), Contains("room.pgm: header: 0 x 2 pixels, expected at least 1 x 1"));
  CHECK_THAT(message_of(yaml, "P5 8000 8000 255\n"), Contains("expected 64000000 for 8000 x 8000"));
  CHECK_THAT(message_of(yaml, "P5 2 2 0\n"), Contains("0, expected a brightest value from 1 to 65535"));
  CHECK_THAT(message_of(yaml, "P2 2 1 9 5 10"), Contains("10, expected a pixel of at most 9"));
  CHECK_THAT(message_of(yaml, "P6 2 2 255\n"), Contains("0 bytes of pixels until the end of the file, expected 12"));
  CHECK_THAT(message_of(yaml, "P7 2 2 255\n"), Contains("room.pgm: byte 0: neither"));
  CHECK_THAT(message_of(yaml, "\xFF\xD8\xFF\xE0 JFIF"), Contains("room.pgm: header: libjpeg"));
  CHECK_THAT(message_of(yaml, "GIF89a"), Contains("expected a PNG, PGM, PPM, BMP or JPEG image"));
  CHECK_THAT(message_of(yaml, "version https://git-lfs.github.com/spec/v1\n"), Contains("is a pointer of Git LFS"));
  CHECK_THAT(message_of(yaml, ""), Contains("room.pgm: byte 0: neither"));
  CHECK_THAT(message_of(yaml, "\x89PNG\r\n\x1a\n"), Contains("room.pgm: header: libpng"));
  CHECK_THAT(message_of(yaml, room().png().substr(0, 60)), Contains("room.pgm: pixels: libpng"));
  CHECK_THAT(message_of(yaml_for("missing.png")),
             Contains("missing.png: cannot read the file: No such file or directory"));
  CHECK_THAT(message_of(yaml_for(".")), Contains("cannot read the file"));
}

TEST_CASE("an image is found under its name beside the yaml file, from Windows, in other case, or renamed with it") {
  const auto map = import_yaml(yaml_for("room.pgm")).map;
  for (const char* named : {"C:\\Users\\me\\maps\\room.pgm", "maps/ROOM.PGM", "Room.pgm"})
    CHECK(same_geometry(*map, *import_yaml(yaml_for(named)).map));
  const MapImport renamed = import_yaml(yaml_for("/home/me/map.pgm"));
  CHECK(same_geometry(*map, *renamed.map));
  CHECK_THAT(renamed.report.back(), Contains("the image /home/me/map.pgm is not there: room.pgm was read"));
}

TEST_CASE("a yaw that is no number is 0, and that is told") {
  const MapImport imported = import_yaml(yaml_for("room.pgm", "[0, 0, -nan]"));
  CHECK(same_geometry(*import_yaml(yaml_for("room.pgm")).map, *imported.map));
  CHECK_THAT(imported.report.back(), Contains("the yaw of origin is no number"));
  CHECK_THROWS_WITH(import_yaml(yaml_for("room.pgm", "[nan, 0, 0]")), Contains("three finite numbers"));
}
