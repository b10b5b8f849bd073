// A unit that doors and walls contradict is doubted, with what would fit.
#include "dxf_text.hpp"
#include "import_source.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using nlohmann::json;

namespace {

MapImport sized_dxf(const DxfText& dxf, const json& options = json::object()) {
  return import_text("dxf_importer", "opal:DxfImporter", "plan.dxf", dxf.text(), options);
}

/// Rooms of 5 m x 4 m in two rows, with walls of 0.2 m and, if wanted, doors of 0.9 m; lengths in metres times `scale`.
DxfText rooms(int insunits, double scale, bool has_doors) {
  DxfText dxf(insunits);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 4; ++column) {
      const double x = 5.0 * column, y = 4.0 * row;
      dxf.box("A-WALL", scale * x, scale * y, scale * (x + 0.2), scale * (y + 4));
      dxf.box("A-WALL", scale * (x + 0.2), scale * y, scale * (x + 4), scale * (y + 0.2));
      if (has_doors) dxf.arc("A-DOOR", {scale * (x + 4), scale * y}, scale * 0.9, 0, 90);
    }
  return dxf;
}

constexpr const char* kLeaves = "doubtful: leaves of doors are ";

}  // namespace

TEST_CASE("doors and walls that another unit was meant for make the unit doubtful, and the one that fits is named") {
  const MapImport plan = sized_dxf(rooms(1, 100, true));  // drawn in cm, and said to be in inches
  CHECK(says(plan, std::string(kLeaves) + "2.29 m wide (median of 8), walls 0.51 m thick, expected 0.6 to 1.3 m"));
  CHECK(says(plan, "is the unit right (in)?"));
  CHECK(says(plan, "; in cm they would be 0.90 m (--set unit=cm)"));
  CHECK(says(sized_dxf(rooms(5, 100 / 2.54, true)), std::string(kLeaves) + "0.35 m wide"));
  CHECK(says(sized_dxf(rooms(5, 100 / 2.54, true)), "; in in they would be 0.90 m (--set unit=in)"));
  CHECK_FALSE(says(sized_dxf(rooms(5, 100, true)), "is the unit right"));
  CHECK_FALSE(says(sized_dxf(rooms(1, 100, true), {{"unit", "cm"}}), "is the unit right"));
}

TEST_CASE("without a door, walls that are all thick inside of the building, or all thin, make the unit doubtful") {
  CHECK(says(sized_dxf(rooms(1, 100, false)), "doubtful: walls are 0.51 m thick, and hardly any is thinner than"));
  CHECK(says(sized_dxf(rooms(4, 1000 / 3.28, false)), "doubtful: walls are 0.06 m thick, and hardly any is thicker"));
  CHECK_FALSE(says(sized_dxf(rooms(5, 100, false)), "is the unit right"));
}

TEST_CASE("small arcs of handles, and a gate among doors, leave the unit alone") {
  DxfText dxf = rooms(6, 1, true);
  for (int k = 0; k < 4; ++k) dxf.arc("A-DOOR", {5.0 * k, 9}, 0.05, 0, 90);
  CHECK_FALSE(says(sized_dxf(dxf.arc("A-DOOR", {9, 9}, 3, 0, 90)), "is the unit right"));
}

TEST_CASE("the unit may be a length in metres") {
  const MapImport plan = sized_dxf(rooms(0, 50, true), {{"unit", "0.02"}});
  CHECK(says(plan, "drawing in units of 0.02 m, as the option unit says"));
  CHECK(says(plan, "extent 19.90 m x 8.00 m"));
}
