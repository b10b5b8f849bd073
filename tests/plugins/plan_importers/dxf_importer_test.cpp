#include "dxf_text.hpp"
#include "import_source.hpp"

#include <opal/common/error.hpp>
#include "map/check/map_check.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;
using nlohmann::json;

namespace {

MapImport import_dxf(const std::string& text, const json& options = json::object()) {
  return import_text("dxf_importer", "opal:DxfImporter", "plan.dxf", text, options);
}

}  // namespace

TEST_CASE("a small office comes in with its walls, columns, doors and glass, and all else is reported") {
  const MapImport office = import_dxf(small_office());
  const auto circles = all<Circle>(*office.map);
  CHECK(circles.size() == 6);
  CHECK(has_face(*office.map, {24, 0}, {0, 0}));
  CHECK(has_face(*office.map, {0.8, 5}, {0.8, 4.85}));  // the reveal of a door
  CHECK_FALSE(has_face(*office.map, {0.8, 5}, {1.7, 5}));
  const MapCheck check = check_map(*office.map);
  CHECK(check.objects_by_type.at("opal:Door") == 6);
  CHECK(check.objects_by_type.at("opal:Window") == 1);
  CHECK(check.objects_by_type.at("opal:Column") == 7);
  CHECK(check.warnings.empty());  // doors and glass that no sensor perceives are as they should be
  CHECK(says(office, "drawing in mm, as $INSUNITS says"));
  CHECK(says(office, "extent 24.00 m x 12.00 m"));
  CHECK(says(office, "circles that were drawn as closed lines: 1"));
  CHECK(says(office, "left out, no class for its layer: layer A-FURN: 2 LWPOLYLINE"));
  CHECK(says(office, "left out, no class for its layer: layer A-ANNO: 1 TEXT"));
  CHECK(says(office, "left out, its layer is frozen: layer A-OLD: 1 LINE"));
  CHECK(says(office, "left out, entities of this type are not read: layer A-WALL: 1 REGION"));
  for (const MapFeature& feature : office.map->features())
    if (office.map->object(feature.object).type == "opal:Door") CHECK(feature.sensor.empty());
}

TEST_CASE("the unit is the drawing's, or that of the option, or asked for") {
  const auto wall = [](int insunits) { return DxfText(insunits).box("A-WALL", 0, 0, 5000, 200).text(); };
  CHECK(has_face(*import_dxf(wall(4)).map, {5, 0}, {0, 0}));
  CHECK(all<Segment>(*import_dxf(wall(1)).map).size() == 8);  // five metres thick: no wall, but rooms
  CHECK(has_face(*import_dxf(wall(0), {{"unit", "mm"}}).map, {5, 0}, {0, 0}));
  CHECK(says(import_dxf(wall(4), {{"unit", "cm"}}), "$INSUNITS 4 says another unit"));
  CHECK_THROWS_WITH(import_dxf(wall(0)), Contains("plan.dxf: does not say in which unit it is drawn") &&
                                             Contains("m, dm, cm, mm, in, ft, yd"));
  CHECK_THROWS_AS(import_dxf(wall(-1)), MapError);
  CHECK_THROWS_WITH(import_dxf(wall(7)), Contains("$INSUNITS 7"));
  CHECK_THROWS_WITH(import_dxf(wall(4), {{"unit", "miles"}}),
                    Contains("option unit: \"miles\", expected one of: m, dm"));
}

TEST_CASE("layers become classes by rules; what no rule knows is named") {
  DxfText dxf(6);
  dxf.box("Innenwand", 0, 0, 5, 0.2).circle("RUNDLINGE", {3, 3}, 0.2).line("A-WALL-CNTR", {0, 0.1}, {5, 0.1});
  CHECK_THROWS_WITH(import_dxf(dxf.text(), {{"classes", {{"*wand", "leave_out"}}}}),
                    Contains("no layer gives anything") && Contains("'Innenwand' (1 LWPOLYLINE)") &&
                        Contains("'RUNDLINGE' (1 CIRCLE)"));
  const MapImport plan =
      import_dxf(dxf.text(), {{"classes", {{"innen*", "Wall"}, {"RUNDLINGE", "opal:Column"}, {"NOTHING*", "Wall"}}}});
  CHECK(all<Circle>(*plan.map).size() == 1);
  CHECK(all<Segment>(*plan.map).size() == 4);
  CHECK(says(plan, "no layer is called 'NOTHING*'"));
  CHECK(thing(plan, "102").status == ImportStatus::left_out);
  CHECK(thing(plan, "102").reason == "a rule for its layer says so");
}

TEST_CASE("blocks are put in their places: nested, scaled, turned, mirrored, in arrays") {
  DxfText dxf(6);
  dxf.begin_block("POST", {1, 0}).circle("0", {1, 0}, 0.1).end_block();
  dxf.begin_block("PAIR").insert("0", "post", {0, 0}).insert("0", "POST", {2, 0}).end_block();
  dxf.insert("S-COLS", "PAIR", {10, 10}, 2, 2, 90);
  dxf.insert("S-COLS", "PAIR", {0, 0}, -1, 1);
  dxf.insert("S-COLS", "POST", {20, 0}).pair(70, 3).pair(71, 2).pair(44, 1.5).pair(45, 2.5);
  const MapImport plan = import_dxf(dxf.text());
  const auto circles = all<Circle>(*plan.map);
  REQUIRE(circles.size() == 10);
  const auto has = [&](const Point& centre, double radius_m) {
    return std::any_of(circles.begin(), circles.end(), [&](const Circle& c) {
      return (c.center - centre).norm() < 1e-9 && std::abs(c.radius_m - radius_m) < 1e-9;
    });
  };
  CHECK(has({10, 10}, 0.2));
  CHECK(has({10, 14}, 0.2));
  CHECK(has({-2, 0}, 0.1));
  CHECK(has({23, 2.5}, 0.1));
  CHECK(thing(plan, "105[2,1]/100").status == ImportStatus::imported);
}

TEST_CASE("a block on the other side of the plane is mirrored, and a tilted circle is refused by name") {
  DxfText dxf(6);
  dxf.circle("S-COLS", {2, 3}, 0.2).pair(210, 0).pair(220, 0).pair(230, -1);
  dxf.circle("S-COLS", {5, 3}, 0.2).pair(210, 1).pair(220, 0).pair(230, 0);
  dxf.arc("A-WALL", {-4, 0}, 2, 0, 90).pair(230, -1);
  const MapImport plan = import_dxf(dxf.text());
  REQUIRE(all<Circle>(*plan.map).size() == 1);
  CHECK((all<Circle>(*plan.map)[0].center - Point(-2, 3)).norm() < 1e-9);
  CHECK(thing(plan, "101").status == ImportStatus::unreadable);
  CHECK(thing(plan, "101").reason == "its plane is tilted against the plan");
  const ImportedElement arc = thing(plan, "102");
  CHECK((arc.outline.front().begin - Point(4, 2)).norm() < 1e-9);
  CHECK((arc.outline.back().end - Point(2, 0)).norm() < 1e-9);
}

TEST_CASE("bulges are arcs, and two half circles are a circle") {
  DxfText dxf(6);
  dxf.polyline("S-COLS", {{0, 0}, {0.4, 0}}, true, {1, 1});
  dxf.polyline("A-WALL", {{0, 5}, {2, 5}, {2, 9}}, false, {0, -0.41421356});
  const MapImport plan = import_dxf(dxf.text());
  REQUIRE(all<Circle>(*plan.map).size() == 1);
  CHECK(all<Circle>(*plan.map)[0].radius_m == Approx(0.2));
  const ImportedElement line = thing(plan, "101");
  for (const Segment& chord : line.outline) {
    const double off = std::abs((chord.midpoint() - Point(0, 7)).norm() - std::sqrt(8.0));
    if (chord.length_m() < 1.9)
      CHECK(std::min(off, std::abs((chord.midpoint() - Point(4, 7)).norm() - std::sqrt(8.0))) < 0.006);
  }
  CHECK(says(plan, "curved lines that became short straight ones"));
}

TEST_CASE("ellipses are chords that are near to them; a round one is a column") {
  DxfText dxf(6);
  dxf.ellipse("A-WALL", {0, 0}, {0, 4}, 0.5, 0, std::numbers::pi / 2);
  dxf.ellipse("S-COLS", {9, 3}, {0.2, 0}, 1, 0, 2 * std::numbers::pi);
  dxf.ellipse("A-WALL", {20, 0}, {4, 0}, 0.5, 0, std::numbers::pi / 2).pair(230, -1);
  const MapImport plan = import_dxf(dxf.text());
  for (const char* id : {"100", "102"}) {
    const ImportedElement wall = thing(plan, id);
    REQUIRE(wall.outline.size() > 8);
    const bool is_below = wall.id == "102";
    for (const Segment& chord : wall.outline) {
      const Point p = chord.midpoint() - (is_below ? Point(20, 0) : Point(0, 0));
      const double round = is_below ? std::hypot(p.x() / 4, p.y() / 2) : std::hypot(p.x() / 2, p.y() / 4);
      CHECK(std::abs(round - 1) < 0.0025);
      CHECK((is_below ? p.x() > 0 && p.y() < 0 : p.x() < 0 && p.y() > 0));
    }
  }
  REQUIRE(all<Circle>(*plan.map).size() == 1);
  CHECK(all<Circle>(*plan.map)[0].radius_m == Approx(0.2));
}

TEST_CASE("splines are chords that are near to them, rational or not; without control points they are named") {
  DxfText dxf(6);
  dxf.spline("A-WALL", 2, {0, 0, 0, 1, 1, 1}, {{3, 0}, {3, 3}, {0, 3}},
             {1, std::sqrt(0.5), 1});  // a quarter of a circle
  dxf.spline("A-WALL", 3, {0, 0, 0, 0, 1, 1, 1, 1}, {{10, 0}, {11, 1}, {13, 1}, {14, 0}});
  dxf.entity("SPLINE", "A-WALL")
      .pair(70, 1064)
      .pair(71, 3)
      .pair(72, 0)
      .pair(73, 0)
      .pair(74, 2)
      .point(11, {0, 9})
      .point(11, {3, 9});
  dxf.spline("A-WALL", 3, {0, 0, 0, 0, 0, 0, 0, 0}, {{10, 0}, {11, 1}, {13, 1}, {14, 0}});
  const MapImport plan = import_dxf(dxf.text());
  const ImportedElement arc = thing(plan, "100"), wave = thing(plan, "101");
  REQUIRE(arc.outline.size() > 4);
  for (const Segment& chord : arc.outline) CHECK(std::abs(chord.midpoint().norm() - 3) < 0.006);
  double highest_m = 0;
  for (const Segment& chord : wave.outline) highest_m = std::max(highest_m, chord.end.y());
  CHECK(highest_m == Approx(0.75).margin(0.005));
  CHECK(thing(plan, "102").status == ImportStatus::unreadable);
  CHECK_THAT(thing(plan, "102").reason, Contains("no control points"));
  CHECK_THAT(thing(plan, "103").reason, Contains("knots do not rise"));
  CHECK_THROWS_WITH(import_dxf(DxfText(6).spline("A-WALL", 1, {0, 0, 1, 1}, {{0, 0}, {1, 0}}).pair(10, 3).text()),
                    Contains("SPLINE: 3 times code 10, expected 2, as code 73 says"));
}

TEST_CASE("a multiline is all its lines: a wall with two faces") {
  const MapImport plan = import_dxf(DxfText(6).mline("A-WALL", {0, 0}, {5, 0}, 0.1).text());
  CHECK(has_face(*plan.map, {5, -0.1}, {0, -0.1}));
  CHECK(has_face(*plan.map, {0, 0.1}, {5, 0.1}));
  CHECK(all<Segment>(*plan.map).size() == 2);
}

TEST_CASE("a hatch or a filled shape says where the wall is") {
  DxfText dxf(6);
  dxf.box("A-WALL", 0, 0, 3, 2);
  dxf.entity("SOLID", "A-WALL").point(10, {0, 0}).point(11, {3, 0}).point(12, {0, 2}).point(13, {3, 2});
  CHECK(all<Segment>(*import_dxf(dxf.text()).map).size() == 4);
  DxfText alone(6);
  alone.entity("SOLID", "S-COLS").point(10, {0, 0}).point(11, {0.4, 0}).point(12, {0, 0.3}).point(13, {0.4, 0.3});
  CHECK(has_face(*import_dxf(alone.text(), {{"unit", "m"}}).map, {0.4, 0}, {0, 0}));
  const auto hatched = [](bool as_polyline) {
    DxfText text(6);
    text.box("A-WALL", 0, 0, 3, 2)
        .entity("HATCH", "A-WALL-PATT")
        .point(10, {0, 0})
        .pair(2, "SOLID")
        .pair(70, 1)
        .pair(71, 0)
        .pair(91, 1);
    const std::vector<Point> ring{{0, 0}, {3, 0}, {3, 2}, {0, 2}};
    if (as_polyline) {
      text.pair(92, 3).pair(72, 0).pair(73, 1).pair(93, 4);
      for (const Point& p : ring) text.point(10, p);
    } else {
      text.pair(92, 1).pair(93, 4);
      for (std::size_t k = 0; k < 4; ++k) text.pair(72, 1).point(10, ring[k]).point(11, ring[(k + 1) % 4]);
    }
    return text.pair(97, 0).pair(75, 0).pair(76, 1).pair(98, 0).text();
  };
  CHECK(all<Segment>(*import_dxf(hatched(true)).map).size() == 4);
  CHECK(all<Segment>(*import_dxf(hatched(false)).map).size() == 4);
}

TEST_CASE("old polylines are read vertex by vertex, meshes are reported") {
  DxfText dxf(6);
  dxf.entity("POLYLINE", "A-WALL").pair(66, 1).pair(70, 1);
  for (const Point& p : {Point(0, 0), Point(5, 0), Point(5, 0.2), Point(0, 0.2)})
    dxf.entity("VERTEX", "A-WALL").point(10, p);
  dxf.entity("SEQEND", "A-WALL");
  dxf.entity("POLYLINE", "A-WALL").pair(66, 1).pair(70, 64).entity("SEQEND", "A-WALL");
  const MapImport plan = import_dxf(dxf.text());
  CHECK(all<Segment>(*plan.map).size() == 4);
  CHECK(thing(plan, "106").reason == "a mesh in space");
}

TEST_CASE("blocks that are missing, external, endless or too many are said or refused") {
  const auto with_wall = [](DxfText& dxf) { return dxf.box("A-WALL", 0, 0, 5, 0.2).text(); };
  DxfText missing(6);
  CHECK(thing(import_dxf(with_wall(missing.insert("S-COLS", "NOWHERE", {0, 0}))), "100").reason ==
        "its block 'NOWHERE' is not in the file");
  DxfText empty(6);
  empty.begin_block("NOTHING").end_block();
  CHECK(thing(import_dxf(with_wall(empty.insert("S-COLS", "NOTHING", {0, 0}))), "100").reason ==
        "its block 'NOTHING' is empty");
  DxfText endless(6);
  endless.begin_block("A")
      .insert("S-COLS", "B", {1, 0})
      .end_block()
      .begin_block("B")
      .insert("S-COLS", "A", {1, 0})
      .end_block();
  CHECK_THROWS_WITH(import_dxf(with_wall(endless.insert("S-COLS", "A", {0, 0}))),
                    Contains("block 'A' > 'B' > 'A': it contains itself"));
  DxfText bomb(6);
  bomb.begin_block("L0").circle("S-COLS", {0, 0}, 0.1).end_block();
  for (int level = 1; level < 25; ++level) {
    bomb.begin_block("L" + std::to_string(level));
    for (int k = 0; k < 10; ++k) bomb.insert("0", "L" + std::to_string(level - 1), {1.0 * k, 0});
    bomb.end_block();
  }
  CHECK_THROWS_WITH(import_dxf(with_wall(bomb.insert("S-COLS", "L24", {0, 0}))), Contains("more than 300000 entities"));
  DxfText array(6);
  array.begin_block("EMPTY").end_block();
  array.insert("S-COLS", "EMPTY", {0, 0}).pair(70, 2000000000).pair(71, 2000000000);
  CHECK_THROWS_WITH(import_dxf(with_wall(array)), Contains("more than 300000 entities"));
}

TEST_CASE("a file that is damaged is refused with the line") {
  const std::string good = DxfText(6).box("A-WALL", 0, 0, 5, 0.2).line("A-WALL", {0, 3}, {4, 3}).text();
  REQUIRE_NOTHROW(import_dxf(good));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.rfind(from), from.size(), to);
  };
  CHECK_THROWS_WITH(import_dxf(""), Contains("plan.dxf: is empty"));
  CHECK_THROWS_WITH(import_dxf(with("0\nENDSEC\n0\nEOF\n", "")), Contains("cut off"));
  CHECK_THROWS_WITH(import_dxf(with("0\nENDSEC\n0\nEOF\n", "0\nEOF\n")), Contains("has no end, expected 0 ENDSEC"));
  CHECK_THROWS_WITH(import_dxf(with("21\n3\n", "")), Contains("LINE: no code 21, expected one"));
  CHECK_THROWS_WITH(import_dxf(with("21\n3\n", "21\nnan\n")), Contains("\"nan\" for code 21, expected a number"));
  CHECK_THROWS_WITH(import_dxf(with("21\n3\n", "21\n1e300\n")), Contains("expected a number"));
  CHECK_THROWS_WITH(import_dxf(with("21\n3\n", "21\n3\n21\n4\n")), Contains("2 times code 21"));
  CHECK_THROWS_WITH(import_dxf(with("90\n4\n", "90\n5\n")), Contains("4 x and 4 y of vertices beside code 90"));
  CHECK_THROWS_WITH(import_dxf(with("21\n3\n", "21\n")), Contains("expected"));
  CHECK_THROWS_WITH(import_dxf("\xFF\xFE" + good), Contains("expected a group code"));
  CHECK_THROWS_WITH(import_dxf("AutoCAD Binary DXF\r\n\x1a"), Contains("binary DXF"));
  CHECK_NOTHROW(import_dxf(good + std::string("\x1A\0\0", 3)));
  CHECK(all<Segment>(*import_dxf("\xEF\xBB\xBF" + good).map).size() == 6);
  std::string crlf;
  for (const char c : good) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  CHECK(all<Segment>(*import_dxf(crlf).map).size() == 6);
}

TEST_CASE("the origin option moves a plan that is drawn far away") {
  DxfText dxf(6);
  dxf.box("A-WALL", 5000000, 4000000, 5000005, 4000000.2);
  const MapImport rounded = import_dxf(dxf.text());
  CHECK(says(rounded, "the map's origin is at 5000000, 4000000 m of the plan (--set origin_x_m and origin_y_m"));
  CHECK(has_face(*rounded.map, {5, 0}, {0, 0}));
  CHECK_THROWS_WITH(import_dxf(dxf.text(), {{"origin_x_m", 1}}), Contains("within 1e6 m of the origin"));
  CHECK_THROWS_WITH(import_dxf(dxf.box("A-WALL", 0, 0, 5, 0.2).text()), Contains("within 1e6 m of the origin"));
  DxfText far(6);
  far.box("A-WALL", 5000000, 4000000, 5000005, 4000000.2);
  CHECK(has_face(*import_dxf(far.text(), {{"origin_x_m", 5000000}, {"origin_y_m", 4000000}}).map, {5, 0}, {0, 0}));
}
