#include "dxf_text.hpp"
#include "import_source.hpp"

#include <opal/common/error.hpp>
#include "map/check/map_check.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;
using nlohmann::json;

namespace {

MapImport tolerated_dxf(const std::string& text, const json& options = json::object()) {
  return import_text("dxf_importer", "opal:DxfImporter", "plan.dxf", text, options);
}

}  // namespace

TEST_CASE("a loop of a hatch whose edges do not meet is left out; edges may be written either way round") {
  const auto hatched = [](const std::vector<std::pair<Point, Point>>& edges) {
    DxfText text(6);
    text.box("A-WALL", 10, 0, 15, 0.2).entity("HATCH", "A-WALL").point(10, {0, 0}).pair(2, "SOLID").pair(70, 1);
    text.pair(71, 0).pair(91, 1).pair(92, 1).pair(93, static_cast<double>(edges.size()));
    for (const auto& [from, to] : edges) text.pair(72, 1).point(10, from).point(11, to);
    return tolerated_dxf(text.pair(97, 0).pair(75, 0).pair(76, 1).pair(98, 0).text());
  };
  const Point a(0, 0), b(3, 0), c(3, 2), d(0, 2);
  for (const auto& edges : {std::vector<std::pair<Point, Point>>{{a, b}, {b, c}, {c, d}, {d, a}},
                            {{b, a}, {b, c}, {d, c}, {d, a}},
                            {{b, a}, {c, b}, {c, d}, {a, d}}})
    CHECK(all<Segment>(*hatched(edges).map).size() == 8);
  const MapImport open = hatched({{a, b}, {c, d}, {{50, 40}, {51, 40}}});
  CHECK(all<Segment>(*open.map).size() == 4);
  CHECK(thing(open, "101").reason == "it has no boundary that can be read");
}

TEST_CASE("a door of blocks inside blocks is one door, and what is drawn twice is there once") {
  DxfText dxf(6);
  dxf.box("A-WALL", 0, 0, 5, 0.2);
  dxf.begin_block("HANDLE").box("0", 0, 0, 0.1, 0.1).circle("0", {0, 0}, 0.05).end_block();
  dxf.begin_block("DOOR").line("0", {0, 0}, {1, 0}).insert("0", "HANDLE", {0.9, 0}).insert("0", "HANDLE", {0.9, 0});
  dxf.end_block().insert("A-DOOR", "DOOR", {1, 2});
  const MapImport imported = tolerated_dxf(dxf.text());
  const MapCheck check = check_map(*imported.map);
  CHECK(check.objects_by_type.at("opal:Door") == 1);
  CHECK(check.warnings.empty());
}

TEST_CASE("sections that are no part of the plan hold anything") {
  const std::string good = DxfText(6).box("A-WALL", 0, 0, 5, 0.2).text();
  const std::string end = "0\nEOF\n";
  const auto with = [&](const std::string& section) {
    return good.substr(0, good.size() - end.size()) + section + end;
  };
  for (const char* section : {"0\nSECTION\n2\nTHUMBNAILIMAGE\n90\n4\n310\n00FF\n0\nENDSEC\n",
                              "0\nSECTION\n2\nACDSDATA\n70\n2\n71\n6\n0\nACDSSCHEMA\n90\n0\n0\nENDSEC\n",
                              "0\nSECTION\n2\nOF A LATER RELEASE\n0\nENDSEC\n"})
    CHECK(all<Segment>(*tolerated_dxf(with(section)).map).size() == 4);
  CHECK_THROWS_WITH(tolerated_dxf(with("0\nSECTION\n2\nTHUMBNAILIMAGE\n90\n4\n")),
                    Contains("section THUMBNAILIMAGE has no end"));
}

TEST_CASE("what is damaged is no matter where nothing is made of it") {
  const auto drawing = [](const std::string& layer) {
    DxfText dxf(6);
    dxf.box("A-WALL", 0, 0, 5, 0.2);
    dxf.entity("LINE", layer).point(10, {0, 0}).pair(11, std::string("nan")).pair(21, 1);
    return dxf.text();
  };
  const MapImport imported = tolerated_dxf(drawing("A-FURN"));
  CHECK(all<Segment>(*imported.map).size() == 4);
  CHECK(thing(imported, "101").reason == "no class for its layer");
  CHECK_THROWS_WITH(tolerated_dxf(drawing("A-WALL")), Contains("\"nan\" for code 11, expected a number"));
}

TEST_CASE("entities of later releases are told about, and hidden ones stay out") {
  DxfText dxf(6);
  dxf.box("A-WALL", 0, 0, 5, 0.2);
  dxf.entity("MULTILEADER", "A-WALL").pair(270, 2).pair(300, std::string("CONTEXT_DATA{")).pair(40, 1).pair(40, 2);
  dxf.entity("LINE", "A-WALL").pair(60, 1).point(10, {0, 3}).point(11, {4, 3});
  const MapImport imported = tolerated_dxf(dxf.text());
  CHECK(all<Segment>(*imported.map).size() == 4);
  CHECK(thing(imported, "101").status == ImportStatus::unreadable);
  CHECK(thing(imported, "102").reason == "it is hidden");
}

TEST_CASE("names of layers are read in the code page of the drawing, in UTF-8 and with escapes") {
  const auto with = [](const std::string& layer) {
    std::string text = DxfText(6).box(layer, 0, 0, 5, 0.2).text();
    return text.insert(text.find("9\n$INSUNITS"), "9\n$DWGCODEPAGE\n3\nANSI_1252\n");
  };
  for (const char* layer : {"W\xC4NDE", "W\xC3\x84NDE", "W\\U+00C4NDE"}) {
    CAPTURE(layer);
    CHECK(says(tolerated_dxf(with(layer)), "layer W\xC3\x84NDE as opal:Wall"));
  }
  std::string russian = with("\xD1\xD2\xC5\xCD\xC0");
  russian.replace(russian.find("ANSI_1252"), 9, "ANSI_1251");
  CHECK(says(tolerated_dxf(russian, {{"classes", {{"СТЕН*", "Wall"}}}}), "layer СТЕНА as opal:Wall"));
}

TEST_CASE("a drawing whose unit makes a doll's house of it is refused, unless the option says so") {
  const std::string text = DxfText(4).box("A-WALL", 0, 0, 700, 500).text();
  CHECK_THROWS_WITH(tolerated_dxf(text), Contains("what has a class is 0.70 m large in mm, as $INSUNITS says"));
  CHECK_NOTHROW(tolerated_dxf(text, {{"unit", "in"}}));
  CHECK_NOTHROW(tolerated_dxf(text, {{"unit", "mm"}}));
}

TEST_CASE("what follows EOF is no part of the drawing, and is told") {
  const std::string good = DxfText(6).box("A-WALL", 0, 0, 5, 0.2).text();
  const MapImport imported = tolerated_dxf(good + "ignored\n\n" + std::string("zero\0\n", 6) + "EOF");
  CHECK(all<Segment>(*imported.map).size() == 4);
  CHECK(says(imported, "left out: lines of text after EOF, where the drawing ends: 3"));
  CHECK_FALSE(says(tolerated_dxf(good), "after EOF"));
  CHECK_THROWS_WITH(tolerated_dxf(std::string("0\nSEC\0TION\n", 12) + good), Contains(":2: holds a zero byte"));
}

TEST_CASE("of two blocks with one name the first counts; it is doubtful only if the second differs and becomes map") {
  const auto drawing = [](const std::string& layer, double second_size) {
    DxfText dxf(6);
    dxf.box("A-WALL", 0, 0, 5, 0.2);
    dxf.begin_block("Chair").box("0", 0, 0, 0.5, 0.5).end_block();
    dxf.begin_block("CHAIR").box("0", 0, 0, second_size, 0.5).end_block();
    return dxf.insert(layer, "chair", {1, 2}).text();
  };
  const MapImport furniture = tolerated_dxf(drawing("A-FURN", 0.4));
  CHECK(all<Segment>(*furniture.map).size() == 4);
  CHECK(says(furniture, "left out: a second block of the same name: CHAIR (line "));
  const MapImport same = tolerated_dxf(drawing("S-COLS", 0.5));
  CHECK(has_face(*same.map, {1.5, 2}, {1, 2}));
  CHECK(says(same, "left out: a second block of the same name"));
  CHECK_THROWS_WITH(tolerated_dxf(drawing("S-COLS", 0.4)),
                    Contains("a second block 'CHAIR' that differs from the one at line"));
}

TEST_CASE("a damaged insert is no matter unless it, or what is in its block, becomes map") {
  const auto drawing = [](const std::string& layer, const std::string& inside) {
    DxfText dxf(6);
    dxf.box("A-WALL", 0, 0, 5, 0.2);
    dxf.begin_block("SYMBOL").box(inside, 0, 0, 0.5, 0.5).end_block();
    dxf.entity("INSERT", layer).pair(2, "SYMBOL").point(10, {1, 2}).pair(41, std::string("1.#INF"));
    return dxf.text();
  };
  const MapImport imported = tolerated_dxf(drawing("G-ANNO-SYMB", "0"));
  CHECK(all<Segment>(*imported.map).size() == 4);
  CHECK(thing(imported, "102/101").reason == "no class for its layer");
  CHECK_THROWS_WITH(tolerated_dxf(drawing("S-COLS", "0")), Contains("INSERT: \"1.#INF\" for code 41"));
  CHECK_THROWS_WITH(tolerated_dxf(drawing("G-ANNO-SYMB", "A-WALL")), Contains("INSERT: \"1.#INF\" for code 41"));
}

TEST_CASE("a polyline without its end is no matter on a layer without a class") {
  const auto drawing = [](const std::string& layer) {
    DxfText dxf(6);
    dxf.entity("POLYLINE", layer).pair(66, 1).entity("VERTEX", layer).point(10, {0, 0});
    return dxf.box("A-WALL", 0, 0, 5, 0.2).text();
  };
  const MapImport imported = tolerated_dxf(drawing("TEXT"));
  CHECK(all<Segment>(*imported.map).size() == 4);
  CHECK(thing(imported, "100").reason == "no class for its layer");
  CHECK_THROWS_WITH(tolerated_dxf(drawing("A-WALL")), Contains("POLYLINE without SEQEND"));
}

TEST_CASE("a drawing of which no line of a wall is long enough gives no map") {
  DxfText dxf(4);
  dxf.box("WALL-FIN", 0, 0, 40, 30).box("WALL-FIN", 5000, 0, 5040, 30).line("Fenster", {0, 500}, {5000, 500});
  CHECK_THROWS_WITH(tolerated_dxf(dxf.text()),
                    Contains("no line of walls and columns is 0.05 m long or longer, expected a plan") &&
                        Contains("'WALL-FIN' (2 LWPOLYLINE)"));
}

TEST_CASE("clips of blocks are told, since the blocks come in whole") {
  DxfText dxf(6);
  dxf.box("A-WALL", 0, 0, 5, 0.2);
  const auto with_filter = [&](const char* on) {
    const std::string filter = std::string("0\nSPATIAL_FILTER\n5\n2A\n70\n2\n10\n0\n20\n0\n71\n") + on + "\n";
    std::string text = dxf.text();
    return text.insert(text.rfind("0\nEOF"), "0\nSECTION\n2\nOBJECTS\n" + filter + "0\nENDSEC\n");
  };
  CHECK(says(tolerated_dxf(with_filter("1")),
             "doubtful: clips that show a part of a block (XCLIP), and the block came in whole: 1"));
  CHECK_FALSE(says(tolerated_dxf(with_filter("0")), "XCLIP"));
}

TEST_CASE("the insert that a clip belongs to is named") {
  DxfText dxf(6);
  dxf.begin_block("EAST").box("A-WALL", 0, 0, 5, 0.2).end_block();
  std::string text = dxf.insert("0", "EAST", {0, 0}).text();
  const std::size_t insert = text.rfind("0\nINSERT\n5\n") + 11;
  const std::string handle = text.substr(insert, text.find('\n', insert) - insert);
  const std::string objects =
      "0\nDICTIONARY\n5\nD1\n102\n{ACAD_REACTORS\n330\nFF\n102\n}\n330\n" + handle +
      "\n100\nAcDbDictionary\n3\nACAD_FILTER\n360\nD2\n"
      "0\nDICTIONARY\n5\nD2\n330\nD1\n100\nAcDbDictionary\n3\nSPATIAL\n360\nD3\n"
      "0\nSPATIAL_FILTER\n5\nD3\n330\nD2\n100\nAcDbFilter\n100\nAcDbSpatialFilter\n70\n2\n71\n1\n";
  text.insert(text.rfind("0\nEOF"), "0\nSECTION\n2\nOBJECTS\n" + objects + "0\nENDSEC\n");
  CHECK(says(tolerated_dxf(text), "and the block came in whole: 1 (" + handle + " 'EAST')"));
}

TEST_CASE("drawings in UTF-16 are read, with or without the mark, whatever the order of bytes") {
  DxfText dxf(6);
  const std::string text = dxf.box("Wände", 0, 0, 5, 0.2).text();
  for (const bool is_big : {false, true})
    for (const bool has_mark : {false, true}) {
      CAPTURE(is_big, has_mark);
      std::string wide;
      const auto add = [&](unsigned char high, unsigned char low) {
        wide += static_cast<char>(is_big ? high : low);
        wide += static_cast<char>(is_big ? low : high);
      };
      if (has_mark) add(0xFE, 0xFF);
      for (std::size_t k = 0; k < text.size(); ++k) {
        const auto letter = static_cast<unsigned char>(text[k]);
        add(0, letter < 0x80 ? letter : 0xE4);
        if (letter >= 0x80) ++k;
      }
      CHECK(says(tolerated_dxf(wide), "layer Wände as opal:Wall: 1 LWPOLYLINE"));
    }
}

TEST_CASE("variables of the header may follow its end") {
  DxfText dxf(-1);
  dxf.box("A-WALL", 0, 0, 5, 0.2);
  std::string text = dxf.text();
  const std::size_t after = text.find("0\nSECTION\n2\nTABLES");
  CHECK(says(tolerated_dxf(std::string(text).insert(after, "9\n$DIMASZ\n40\n3.0\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n")),
             "drawing in m, as $INSUNITS says"));
  CHECK_THROWS_WITH(tolerated_dxf(text.insert(after, "9\n$INSUNITS\n70\n6\n")),
                    Contains("expected 0 ENDSEC after variables of the header"));
}
