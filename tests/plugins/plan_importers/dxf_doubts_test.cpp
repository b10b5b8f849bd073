// What a drawing says is read, and what is odd in it is said: doors that a wall closes, units, axes of columns.
#include "dxf_text.hpp"
#include "import_source.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;
using nlohmann::json;

namespace {

MapImport doubted_dxf(const DxfText& dxf, const json& options = json::object()) {
  return import_text("dxf_importer", "opal:DxfImporter", "plan.dxf", dxf.text(), options);
}

constexpr const char* kClosed = "doubtful: doors on a wall that goes on under them, so that the wall closes them: ";
constexpr const char* kUnit = "is the unit right?";

/// A wall of two faces along y = 0, from x = 0 to 10, with or without an opening from 4 to 5.
DxfText wall(bool has_opening) {
  DxfText dxf(6);
  if (has_opening)
    dxf.box("A-WALL", 0, 0, 4, 0.2).box("A-WALL", 5, 0, 10, 0.2);
  else
    dxf.line("A-WALL", {0, 0}, {10, 0}).line("A-WALL", {0, 0.2}, {10, 0.2});
  return dxf;
}

/// A leaf that stands open into the room above, and the arc that it draws.
DxfText& leaf_and_swing(DxfText& dxf, const std::string& layer) {
  return dxf.line(layer, {4, 0.2}, {4, 1.2}).arc(layer, {4, 0.2}, 1, 0, 90);
}

/// A house of 10 m x 8 m with walls of 0.2 m, so many times too large.
DxfText house(int insunits, double scale) {
  DxfText dxf(insunits);
  for (const double in : {0.0, 0.2}) {
    const Point low(in * scale, in * scale), high((10 - in) * scale, (8 - in) * scale);
    const Point right(high.x(), low.y()), left(low.x(), high.y());
    dxf.line("WALLS", low, right).line("WALLS", right, high).line("WALLS", high, left).line("WALLS", left, low);
  }
  return dxf;
}

}  // namespace

TEST_CASE("a door on a wall that is drawn through is told, whether its layer has a class or not") {
  for (const char* layer : {"A-DOOR", "0"}) {
    DxfText closed = wall(false), open = wall(true);
    CHECK(says(doubted_dxf(leaf_and_swing(closed, layer)), kClosed));
    CHECK_FALSE(says(doubted_dxf(leaf_and_swing(open, layer)), kClosed));
  }
}

TEST_CASE("the door block that stands on a wall is named") {
  DxfText dxf(6);
  dxf.begin_block("DOOR");
  leaf_and_swing(dxf, "0").end_block();
  dxf.line("A-WALL", {0, 0}, {10, 0}).line("A-WALL", {0, 0.2}, {10, 0.2}).insert("A-DOOR", "DOOR", {0, 0});
  CHECK(says(doubted_dxf(dxf), std::string(kClosed) + "1 (104/A-DOOR)"));
}

TEST_CASE("a leaf without a swing is told where it lies in a wall that goes on, and not in an opening") {
  DxfText closed = wall(false), open = wall(true);
  CHECK(says(doubted_dxf(closed.line("A-DOOR", {4.05, 0.1}, {4.95, 0.1})), kClosed));
  CHECK_FALSE(says(doubted_dxf(open.line("A-DOOR", {4.05, 0.1}, {4.95, 0.1})), kClosed));
}

TEST_CASE("a leaf that opens to another wall is in order, also if it is drawn open and shut") {
  for (const bool is_drawn_shut : {false, true})
    for (const bool is_drawn_open : {false, true}) {
      DxfText dxf = wall(true);
      dxf.box("A-WALL", 3.7, 0.2, 3.9, 5).arc("A-DOOR", {4, 0.2}, 1, 0, 90);
      dxf.box("A-WALL", 3.7, -5, 3.9, 0);
      if (is_drawn_open) dxf.line("A-DOOR", {4, 0.2}, {4, 1.2});
      if (is_drawn_shut) dxf.line("A-DOOR", {4, 0.2}, {5, 0.2});
      CAPTURE(is_drawn_open, is_drawn_shut);
      CHECK_FALSE(says(doubted_dxf(dxf), kClosed));
    }
}

TEST_CASE("doors that are wider than gates make the unit doubtful") {
  const auto with_doors = [](double width) {
    DxfText dxf(6);
    dxf.box("A-WALL", 0, 0, 20 * width, 0.2);
    for (int k = 1; k < 4; ++k) dxf.arc("A-DOOR", {4 * k * width, 1}, width, 0, 90);
    return doubted_dxf(dxf);
  };
  CHECK(says(with_doors(22.9), "doubtful: leaves of doors are 22.90 m wide (median of 3)"));
  CHECK_FALSE(says(with_doors(1.2), kUnit));
}

TEST_CASE("walls whose faces all lie too far apart make the unit doubtful") {
  CHECK(says(doubted_dxf(house(6, 100)), "most have one at 20.0 m, is the unit right?"));
  CHECK(says(doubted_dxf(house(1, 1000)), "most have one at 5.1 m, is the unit right?"));
  CHECK_FALSE(says(doubted_dxf(house(6, 1)), kUnit));
  CHECK_FALSE(says(doubted_dxf(house(6, 3)), kUnit));  // walls of 0.6 m are thick, not doubtful
}

TEST_CASE("a large plan of single lines has rooms and corridors, and its unit is in order") {
  DxfText dxf(6);
  for (const double y : {0.0, 6.0, 8.0, 14.0}) dxf.line("WALLS", {0, y}, {150, y});
  for (int k = 0; k <= 30; ++k)
    for (const double y : {0.0, 8.0}) dxf.line("WALLS", {5.0 * k, y}, {5.0 * k, y + 6});
  CHECK_FALSE(says(doubted_dxf(dxf), kUnit));
}

TEST_CASE("a unit that the file says and nothing in the plan shows is doubtful") {
  const std::string doubt = "doubtful: no door and no wall with two faces shows whether m is the right unit";
  const auto rooms = [] {
    DxfText dxf(6);
    dxf.polyline("WALLS", {{10, 15}, {60, 15}, {60, 45}, {10, 45}}, true).line("WALLS", {10, 31}, {60, 31});
    return dxf;
  };
  CHECK(says(doubted_dxf(rooms()), doubt));
  CHECK_FALSE(says(doubted_dxf(rooms().line("WALLS", {10, 31.2}, {60, 31.2})), doubt));
  CHECK_FALSE(says(doubted_dxf(rooms().arc("A-DOOR", {20, 31}, 0.9, 0, 90)), doubt));
  CHECK_FALSE(
      says(import_text("dxf_importer", "opal:DxfImporter", "plan.dxf", rooms().text(), {{"unit", "ft"}}), doubt));
}

TEST_CASE("an open line of a column that is as long as an axis is told") {
  const auto with_line = [](double length) {
    DxfText dxf(6);
    return doubted_dxf(dxf.box("S-COLS", 0, 0, 0.3, 0.3).line("S-COLS", {5, 5}, {5 + length, 5}));
  };
  CHECK(says(with_line(4), "doubtful: open lines of columns that are longer than 3 m, as axes are: 1 (101)"));
  CHECK_FALSE(says(with_line(0.5), "as axes are"));
}
