// Polylines that are as wide as walls, faces in space, and files without their last record.
#include "dxf_text.hpp"
#include "import_source.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;

namespace {

MapImport import_wide(const std::string& text) {
  return import_text("dxf_importer", "opal:DxfImporter", "plan.dxf", text);
}

/// A face with its corners in order.
DxfText& face(DxfText& dxf, const std::string& layer, const std::vector<Eigen::Vector3d>& corners) {
  dxf.entity("3DFACE", layer);
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector3d& corner = corners[static_cast<std::size_t>(k) % corners.size()];
    dxf.point(10 + k, corner.head<2>()).pair(30 + k, corner.z());
  }
  return dxf;
}

}  // namespace

TEST_CASE("a polyline with a width is a wall of this thickness, mitred where it turns") {
  DxfText dxf(4);
  dxf.polyline("A-WALL", {{0, 0}, {5000, 0}, {5000, 3000}}, false).pair(43, 200);
  const MapImport plan = import_wide(dxf.text());
  CHECK(says(plan, "walls as thick as their polylines are drawn: 1"));
  CHECK(all<Segment>(*plan.map).size() == 6);
  CHECK(has_face(*plan.map, {5.1, -0.1}, {0, -0.1}));
  CHECK(has_face(*plan.map, {0, 0.1}, {4.9, 0.1}));
}

TEST_CASE("old polylines and vertices say the width, too, and blocks scale it") {
  DxfText dxf(6);
  dxf.begin_block("PIECE").entity("POLYLINE", "0").pair(66, 1).pair(70, 0).pair(40, 2).pair(41, 2);
  for (const Point& p : {Point(0, 0), Point(40, 0)}) dxf.entity("VERTEX", "0").point(10, p);
  dxf.entity("SEQEND", "0").end_block();
  dxf.insert("A-WALL", "PIECE", {0, 0}, 0.1, 0.1);
  const MapImport plan = import_wide(dxf.text());
  CHECK(has_face(*plan.map, {4, -0.1}, {0, -0.1}));
  CHECK(has_face(*plan.map, {0, 0.1}, {4, 0.1}));
}

TEST_CASE("a width that no wall has leaves the middle, and is told; one that changes is none") {
  DxfText dxf(6);
  dxf.polyline("A-WALL", {{0, 0}, {5, 0}}, false).pair(43, 1.5);
  dxf.entity("LWPOLYLINE", "A-WALL")
      .pair(90, 2)
      .pair(70, 0)
      .point(10, {0, 3})
      .pair(40, 0.1)
      .pair(41, 0.3)
      .point(10, {5, 3});
  const MapImport plan = import_wide(dxf.text());
  CHECK(says(plan, "that is no thickness of a wall, of which the middle was taken: 1"));
  CHECK(all<Segment>(*plan.map).size() == 4);
}

TEST_CASE("a ring that is drawn with a width is a round column up to its outer rim") {
  DxfText dxf(6);
  dxf.box("A-WALL", 0, 0, 5, 0.2);
  dxf.polyline("S-COLS", {{1.9, 3}, {2.1, 3}}, true, {1, 1}).pair(43, 0.2);
  const auto columns = all<Circle>(*import_wide(dxf.text()).map);
  REQUIRE(columns.size() == 1);
  CHECK(columns.front().radius_m == Approx(0.2));
}

TEST_CASE("level faces are filled, upright ones are lines, tilted ones are left out") {
  DxfText dxf(6);
  face(dxf, "A-WALL", {{0, 0, 2.5}, {5, 0, 2.5}, {5, 0.2, 2.5}, {0, 0.2, 2.5}});
  face(dxf, "A-WALL", {{0, 3, 0}, {5, 3, 0}, {5, 3, 2.5}, {0, 3, 2.5}});
  face(dxf, "A-WALL", {{0, 6, 0}, {5, 6, 0}, {5, 7, 2.5}});
  const MapImport plan = import_wide(dxf.text());
  CHECK(all<Segment>(*plan.map).size() == 6);
  CHECK(has_face(*plan.map, {5, 0}, {0, 0}));
  CHECK(has_face(*plan.map, {0, 3}, {5, 3}));
  CHECK(says(plan, "it is a tilted face"));
}

TEST_CASE("a drawing that ends after its entities is whole, and that is told") {
  std::string text = DxfText(6).box("A-WALL", 0, 0, 5, 0.2).text();
  text.erase(text.rfind("0\nEOF\n"));
  const MapImport plan = import_wide(text);
  CHECK(all<Segment>(*plan.map).size() == 4);
  CHECK(says(plan, "doubtful: the file ends without EOF"));
}

TEST_CASE("a plan that is small for a building is doubted, and a reference to another file is named") {
  CHECK(says(import_wide(DxfText(1).box("A-WALL", 0, 0, 120, 8).text()), "3.0 m large, is in the right unit?"));
  std::string text = DxfText(6).begin_block("ARCH").end_block().insert("0", "ARCH", {0, 0}).text();
  text.replace(text.find("70\n0\n10\n"), 5, "70\n4\n");
  CHECK_THROWS_WITH(import_wide(text), Contains("stand for other drawings, which are to be bound first: ARCH"));
}
