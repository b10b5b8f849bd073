#include "drawn_building.hpp"

#include "tests/kit/import_report.hpp"
#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;
using Catch::Contains;

namespace {

std::string drawn() {
  DrawnBuilding building;
  const int wall = building.add_wall("wall", {0, 0, 0}, 6, 0.2);
  building.add_door(wall, "door", {1, 0, 0}, 1, 0.2);
  building.add_column("column", {2, 2}, 0.2);
  building.add_storey("Ground", 0);
  return building.text();
}

std::string refusal(const std::string& text) {
  const IfcFile file(text);
  return refused_with<MapError>([&] { ifc_importer({{"z_m", 1}})->import(file.path()); }, file.path());
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

}  // namespace

TEST_CASE("a file that ends early is refused, or told to be cut off, wherever it ends") {
  const std::string text = drawn();
  REQUIRE(refusal(text) == "accepted");
  int accepted = 0;
  for (std::size_t length = 0; length + 2 < text.size(); length += 97) {
    CAPTURE(length);
    const std::string part = text.substr(0, length);
    if (refusal(part) != "accepted") continue;
    ++accepted;
    CHECK(says(import_text(part), "doubtful: the file is cut off in line "));
  }
  CHECK(accepted > 0);
  CHECK_THAT(refusal(text.substr(0, text.find("\n#3="))), Contains("expected"));
}

TEST_CASE("of a file that is cut off comes in what is whole, and what is not is named") {
  const std::string text = drawn();
  const std::size_t column = text.find("IFCCOLUMN"), begin = text.rfind('#', column);
  const std::string wall_only = text.substr(0, begin);
  const MapImport imported =
      import_text(wall_only + "#9000=IFCWALL('0123456789012345678901',$,'half',$,$,#9999,$,$);\n" +
                  "#9001=IFCRELCONTAINEDINSPATIALSTRUCTURE('0123456789012345678902',$,$,$,(#9000),"
                  "#9998);\n#9002=IFCPROPERTYSET('01234567890");
  CHECK(says(imported, "what it would define from there on is missing"));
  CHECK(says(imported, "1 IFCWALL, which need what the file does not define: #9000"));
  CHECK(element(imported, "wall").status == ImportStatus::imported);
  CHECK_THAT(refusal(replaced(wall_only, ".LENGTHUNIT.", ".AREAUNIT.")),
             Contains("; the file is cut off, and may have"));
}

TEST_CASE("openings that a cut-off file cuts from no wall are counted") {
  const std::string text = drawn();
  const std::size_t relation = text.rfind('#', text.find("IFCRELVOIDSELEMENT"));
  CHECK(says(import_text(text.substr(0, relation)), "openings that are cut from no wall, for the file is cut off: 1:"));
  CHECK_FALSE(says(import_text(text.substr(0, text.find("ENDSEC;\nEND-ISO"))), "openings that are cut from no wall"));
}

TEST_CASE("a file may begin with comments and blank lines, and end without its last line") {
  const std::string text = drawn();
  const MapImport whole = import_text(text);
  for (const std::string begin : {"\n\n \t", "/* made by hand */\n", "\n/* ISO-10303-21; */ /* more */\n\n"}) {
    CAPTURE(begin);
    const IfcFile file(begin + text);
    CHECK(ifc_importer({{"z_m", 1}})->recognizes(file.path()));
    CHECK(import_text(begin + text).report == whole.report);
  }
  const std::string data_only = text.substr(0, text.find("END-ISO"));
  CHECK(import_text(data_only).map->features().size() == whole.map->features().size());
  CHECK(says(import_text(data_only), "doubtful: the file ends without END-ISO-10303-21;, after its data"));
  CHECK(import_text(data_only + "END-ISO-10303-21").map->features().size() == whole.map->features().size());
}

TEST_CASE("a file that is cut and closed again is refused for what it misses") {
  const std::string text = drawn();
  const std::size_t end = text.find("\n#20=");
  CHECK_THAT(refusal(text.substr(0, text.find("\n#3=")) + "\nENDSEC;\nEND-ISO-10303-21;\n"), Contains("expected"));
  CHECK(refusal(text.substr(0, end) + "\nENDSEC;\nEND-ISO-10303-21;\n") != "accepted");
}

TEST_CASE("references to nothing, in circles, and numbers given twice are refused by name") {
  const std::string text = drawn();
  CHECK_THAT(refusal(replaced(text, "IFCUNITASSIGNMENT((#1", "IFCUNITASSIGNMENT((#99999")),
             Contains("(IFCUNITASSIGNMENT) refers to #99999, which the file does not define"));
  CHECK_THAT(refusal(replaced(text, "DATA;\n",
                              "DATA;\n#900=IFCLOCALPLACEMENT(#901,$);\n#901=IFCLOCALPLACEMENT(#900,$);\n"
                              "#902=IFCWALL('0123456789012345678901',$,$,$,$,#900,$,$);\n")),
             Contains("in a circle"));
  CHECK_THAT(refusal(replaced(text, "DATA;\n", "DATA;\n#1=IFCDIRECTION((1.,0.,0.));\n")), Contains("is there twice"));
}

TEST_CASE("properties that refer to nothing are left out and told about; the building comes in as without them") {
  const std::string text = drawn();
  const MapImport whole = import_text(text);
  const std::string wall =
      text.substr(text.rfind('#', text.find("IFCWALL")), text.find("=IFCWALL") - text.rfind('#', text.find("IFCWALL")));
  const MapImport imported = import_text(
      replaced(text, "DATA;\n",
               "DATA;\n#900=IFCPROPERTYSINGLEVALUE('a',$,IFCLABEL('b'),#77777);\n"
               "#901=IFCPROPERTYSET('0123456789012345678901',#77778,'set',$,(#900,#77779));\n"
               "#902=IFCRELDEFINESBYPROPERTIES('0123456789012345678902',$,$,$,(" +
                   wall +
                   "),#901);\n"
                   "#903=IFCWALLTYPE('0123456789012345678903',$,'type',$,$,(#901,#77780),$,$,$,.STANDARD.);\n"
                   "#904=IFCRELDEFINESBYTYPE('0123456789012345678904',#77781,$,$,(" +
                   wall + ",#77782),#903);\n"));
  CHECK(imported.map->features().size() == whole.map->features().size());
  CHECK(says(imported, "1 IFCPROPERTYSET, which need what the file does not define"));
  CHECK(says(imported, "#901"));
  CHECK(says(imported, "1 IFCRELDEFINESBYTYPE"));
}

TEST_CASE("space boundaries may refer to each other, and a space to nothing") {
  const std::string text = drawn();
  const std::string end = ",$,$,.PHYSICAL.,.INTERNAL.,$,";
  const MapImport imported = import_text(
      replaced(text, "DATA;\n",
               "DATA;\n#900=IFCRELSPACEBOUNDARY2NDLEVEL('0123456789012345678901',$,$,'2a',$" + end +
                   "#901);\n"
                   "#901=IFCRELSPACEBOUNDARY2NDLEVEL('0123456789012345678902',$,$,'2a',$" +
                   end +
                   "#900);\n"
                   "#902=IFCSPACE('0123456789012345678903',$,'hall',$,$,#77777,#77778,$,.ELEMENT.,.INTERNAL.,$);\n"
                   "#903=IFCRELSPACEBOUNDARY('0123456789012345678904',$,$,$,#902" +
                   end.substr(2, end.size() - 3) + ");\n"));
  CHECK(says(imported, "2 IFCRELSPACEBOUNDARY2NDLEVEL, which refer to each other"));
  CHECK(says(imported, "1 IFCSPACE, which need"));
  CHECK(imported.map->features().size() == import_text(text).map->features().size());
}

TEST_CASE("addresses, units of no length and spaces may be missing") {
  const std::string text = drawn();
  const std::size_t at = text.find("IFCBUILDINGSTOREY");
  const std::string storey = text.substr(text.rfind('#', at), at - 1 - text.rfind('#', at));
  const auto with = [&](const std::string& line) {
    return refusal(replaced(text, "DATA;\n", "DATA;\n" + line + "\n"));
  };
  CHECK(with("#900=IFCBUILDING('0123456789012345678901',$,'b',$,$,$,$,$,.ELEMENT.,$,$,#77777);") == "accepted");
  CHECK(with("#900=IFCDERIVEDUNIT((#77777),.MASSDENSITYUNIT.,$);") == "accepted");
  CHECK(with("#900=IFCRELAGGREGATES('0123456789012345678901',$,$,$," + storey + ",(#77777,#77778));") == "accepted");
  CHECK_THAT(with("#900=IFCRELAGGREGATES('0123456789012345678901',$,$,$,#901,(#77777));\n"
                  "#901=IFCCURTAINWALL('0123456789012345678902',$,$,$,$,$,$,$);"),
             Contains("(IFCRELAGGREGATES) refers to #77777"));
}

TEST_CASE("a wall, its place and its body must be whole") {
  const std::string text = drawn();
  const auto with = [&](const std::string& line) {
    return refusal(replaced(text, "DATA;\n", "DATA;\n" + line + "\n"));
  };
  CHECK(with("#900=IFCWALL('0123456789012345678901',#77777,$,$,$,$,$,$);") == "accepted");
  CHECK_THAT(with("#900=IFCWALL('0123456789012345678901',$,$,$,$,#77777,$,$);"),
             Contains("#900 (IFCWALL) refers to #77777, which the file does not define"));
  CHECK_THAT(
      with("#900=IFCWALL('0123456789012345678901',$,$,$,$,$,#901,$);\n#901=IFCPRODUCTDEFINITIONSHAPE($,$,(#7777));"),
      Contains("#901 (IFCPRODUCTDEFINITIONSHAPE) refers to #7777"));
  CHECK_THAT(with("#900=IFCRELVOIDSELEMENT('0123456789012345678901',$,$,$,#77777,#77778);"),
             Contains("(IFCRELVOIDSELEMENT) refers to #77777"));
}

TEST_CASE("files of IFC2x and IFC2x2 are read as the IFC2x3 that followed") {
  std::string text = drawn();
  for (const char* schema : {"IFC2X_FINAL", "IFC2X2_FINAL", "IFC2X2_ADD1", "ifc2x3"}) {
    CAPTURE(schema);
    const std::string as_2x = replaced(text, "FILE_SCHEMA(('IFC4'))", std::string("FILE_SCHEMA(('") + schema + "'))");
    CHECK(refusal(as_2x) == refusal(replaced(text, "FILE_SCHEMA(('IFC4'))", "FILE_SCHEMA(('IFC2X3'))")));
  }
}

TEST_CASE("a mark of Unicode, lines of Windows and a file that is filled up are no damage") {
  const std::string text = drawn();
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(refusal("\xEF\xBB\xBF" + windows) == "accepted");
  CHECK(refusal(text + std::string(512, '\0')) == "accepted");
  CHECK(refusal(text + "\x1A") == "accepted");
}

TEST_CASE("statements that are none are refused with their line") {
  const std::string text = drawn();
  CHECK_THAT(refusal(replaced(text, "DATA;\n", "DATA;\nnonsense;\n")), Contains("line 8: 'nonsense'"));
  CHECK_THAT(refusal(replaced(text, "DATA;\n", "DATA;\n#900=IFCLABEL('open);\n")), Contains("expected"));
  CHECK_THAT(refusal(replaced(text, "DATA;\n", "DATA;\n/* open\n")), Contains("a comment without an end"));
  CHECK_THAT(refusal(replaced(text, "DATA;\n", "DATA;\n#900=IFCDIRECTION((1.,0.);\n")), Contains("as many ')' as '('"));
}

TEST_CASE("comments, and texts that look like statements, are no statements") {
  const std::string text = drawn();
  CHECK(refusal(replaced(text, "DATA;\n", "DATA;\n/* #1=IFCWALL('; */\n")) == "accepted");
  CHECK(refusal(replaced(text, "$,'drawn',$", "$,'it''s; #77777 (',$")) == "accepted");
}

TEST_CASE("other schemas are refused, IFC4X3 is read as IFC4") {
  const std::string text = drawn();
  CHECK(refusal(replaced(text, "FILE_SCHEMA(('IFC4'))", "FILE_SCHEMA(('IFC4X3_ADD2'))")) == "accepted");
  CHECK(refusal(replaced(text, "FILE_SCHEMA(('IFC4'))", "FILE_SCHEMA(('AP214'))")) ==
        "FILE_SCHEMA: 'AP214', expected IFC2X, IFC2X2, IFC2X3, IFC4 or IFC4X3");
  CHECK_THAT(refusal("a text\n"), Contains("does not begin with ISO-10303-21;"));
  CHECK(refusal("") != "accepted");
}

TEST_CASE("a model without a unit of length is refused") {
  CHECK_THAT(refusal(replaced(drawn(), ".LENGTHUNIT.", ".AREAUNIT.")), Contains("assigns no unit of length"));
}

TEST_CASE("classes that the reader does not know are told about") {
  const MapImport imported =
      import_text(replaced(drawn(), "DATA;\n", "DATA;\n#900=IFCCOURSE('0123456789012345678901',$);\n"));
  bool told = false;
  for (const std::string& sentence : imported.report) told = told || sentence.find("1 IFCCOURSE") != std::string::npos;
  CHECK(told);
}

TEST_CASE("a model of wrong types is refused or reported, and brings nothing down") {
  const std::string text = drawn();
  for (const char* type :
       {"IFCDIRECTION", "IFCLOCALPLACEMENT", "IFCSHAPEREPRESENTATION", "IFCRECTANGLEPROFILEDEF", "IFCWALL"})
    for (const char* by : {"IFCCARTESIANPOINT(", "IFCAXIS2PLACEMENT3D(", "IFCEXTRUDEDAREASOLID(", "IFCPOLYLINE("}) {
      CAPTURE(type, by);
      CHECK_NOTHROW(refusal(replaced(text, std::string(type) + "(", by)));
    }
}

TEST_CASE("bodies that cannot be cut are named with the reason") {
  const std::string text =
      replaced(drawn(), "IFCCIRCLEPROFILEDEF(.AREA.,$,$,0.2)", "IFCCIRCLEPROFILEDEF(.AREA.,$,$,1.E12)");
  const MapImport imported = import_text(text);
  CHECK(element(imported, "column").status == ImportStatus::unreadable);
  CHECK_FALSE(element(imported, "column").reason.empty());
}
