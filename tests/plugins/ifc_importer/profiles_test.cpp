// Sections that the library gives no outline of.
#include "drawn_building.hpp"

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("a beam section with two different flanges has its outline, in IFC4 and in IFC2x3") {
  for (const std::string schema : {"IFC4", "IFC2X3"}) {
    CAPTURE(schema);
    DrawnBuilding building;
    const std::string rest = schema == "IFC4" ? ",$,$,$,$,$" : ",$,$";
    const int profile = building.add("IFCASYMMETRICISHAPEPROFILEDEF", ".AREA.,$,$,2.,3.,0.4,0.5,$,1.5,0.6" + rest);
    building.add_item("IFCMEMBER", "post", building.extruded(profile));
    building.add_wall("wall", {10, 0, 0}, 6, 0.2);
    const MapImport imported = import_text(building.text(schema));
    double twice_area = 0;
    for (const Segment& edge : element(imported, "post").outline) twice_area += cross(edge.begin, edge.end);
    CHECK(std::abs(twice_area) / 2 == Approx(2 * 0.5 + 1.5 * 0.6 + 0.4 * 1.9));
  }
}
