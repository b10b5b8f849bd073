// Kinds of geometry that the models at hand do not have: each comes in as it is meant, or is named with the reason.
#include "drawn_building.hpp"

#include "tests/kit/import_report.hpp"

#include <opal/common/error.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace opal;
using Catch::Contains;

namespace {

constexpr double kPi = std::numbers::pi;

/// What a thing's own cut encloses; holes count against it.
double area_m2(const ImportedElement& element) {
  double twice = 0;
  for (const Segment& s : element.outline) twice += cross(s.begin, s.end);
  return std::abs(twice) / 2;
}

Eigen::AlignedBox<double, 2> box_of(const ImportedElement& element) {
  Eigen::AlignedBox<double, 2> box;
  for (const Segment& s : element.outline) box.extend(s.begin).extend(s.end);
  return box;
}

void check_box(const ImportedElement& element, double x0, double y0, double x1, double y1) {
  INFO(element.id << ": " << element.reason);
  REQUIRE((element.status == ImportStatus::imported || element.status == ImportStatus::merged));
  const Eigen::AlignedBox<double, 2> box = box_of(element);
  CHECK((box.min() - Point(x0, y0)).norm() < 1e-5);
  CHECK((box.max() - Point(x1, y1)).norm() < 1e-5);
  CHECK(area_m2(element) == Approx((x1 - x0) * (y1 - y0)).margin(1e-4));
}

// A box of 4 x 0.2 x 3 m by its corners. Numbered the other way, corner k is number kAnew[k].
constexpr const char* kBoxPoints =
    "((0.,0.,0.),(4.,0.,0.),(4.,.2,0.),(0.,.2,0.),(0.,0.,3.),(4.,0.,3.),(4.,.2,3.),(0.,.2,3.))";
constexpr int kBoxFaces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
constexpr const char* kRenumbering = "(3,1,2,5,4,7,8,6)";
constexpr int kAnew[8] = {2, 3, 1, 5, 4, 8, 6, 7};

int numbered(int corner, bool anew) { return anew ? kAnew[corner] : corner + 1; }

std::string list_of(const std::vector<int>& corners, bool anew) {
  std::string text;
  for (const int corner : corners) text += (text.empty() ? "(" : ",") + std::to_string(numbered(corner, anew));
  return text + ")";
}

std::string triangles(bool anew) {
  std::string text;
  for (const auto& f : kBoxFaces)
    text += (text.empty() ? "(" : ",") + list_of({f[0], f[1], f[2]}, anew) + "," + list_of({f[0], f[2], f[3]}, anew);
  return text + ")";
}

int polygons(DrawnBuilding& building, int points, bool anew) {
  std::string faces;
  for (const auto& f : kBoxFaces)
    faces += (faces.empty() ? "(" : ",") +
             ref(building.add("IFCINDEXEDPOLYGONALFACE", list_of({f[0], f[1], f[2], f[3]}, anew)));
  return building.add("IFCPOLYGONALFACESET", ref(points) + ",.T.," + faces + ")," + (anew ? kRenumbering : "$"));
}

}  // namespace

TEST_CASE("face sets of IFC4 come in, also where their points are numbered anew") {
  const bool anew = GENERATE(false, true);
  DrawnBuilding building;
  const int points = building.add("IFCCARTESIANPOINTLIST3D", kBoxPoints);
  const std::string list = anew ? kRenumbering : "$";
  building.add_item("IFCWALL", "triangles",
                    building.add("IFCTRIANGULATEDFACESET", ref(points) + ",$,.T.," + triangles(anew) + "," + list));
  building.add_item("IFCWALL", "polygons", polygons(building, points, anew));
  const MapImport imported = import(building);
  check_box(element(imported, "triangles"), 0, 0, 4, 0.2);
  check_box(element(imported, "polygons"), 0, 0, 4, 0.2);
}

TEST_CASE("face sets of IFC4X3 have tags, and say earlier whether they are closed") {
  const bool is_draft = GENERATE(false, true);  // drafts of 4.3 had the order of IFC4
  DrawnBuilding building;
  const int points =
      building.add("IFCCARTESIANPOINTLIST3D", std::string(kBoxPoints) + ",('a','b, (c','d','e','f','g','h','i''j')");
  const std::string before = is_draft ? ",$,.T.," : ",.T.,$,";
  building.add_item("IFCWALL", "triangles",
                    building.add("IFCTRIANGULATEDFACESET", ref(points) + before + triangles(false) + ",$"));
  building.add_item("IFCWALL", "polygons", polygons(building, points, false));
  const MapImport imported = import_text(building.text("IFC4X3_ADD2"));
  check_box(element(imported, "triangles"), 0, 0, 4, 0.2);
  check_box(element(imported, "polygons"), 0, 0, 4, 0.2);
}

TEST_CASE("indexed curves come in, with their arcs") {
  DrawnBuilding building;
  const auto wall = [&](const std::string& name, const std::string& points, const std::string& segments,
                        const Pose2& pose) {
    const int list = building.add("IFCCARTESIANPOINTLIST2D", points);
    const int curve = building.add("IFCINDEXEDPOLYCURVE", ref(list) + "," + segments + ",.F.");
    building.add_item("IFCWALL", name,
                      building.extruded(building.add("IFCARBITRARYCLOSEDPROFILEDEF", ".AREA.,$," + ref(curve)), pose));
  };
  wall("plain", "((0.,0.),(2.,0.),(2.,.2),(0.,.2),(0.,0.))", "$", {0, 1, 0});
  wall("lines", "((0.,0.),(2.,0.),(2.,.2),(0.,.2))", "(IFCLINEINDEX((1,2,3)),IFCLINEINDEX((3,4,1)))", {0, 2, 0});
  wall("round ends", "((0.,-.1),(4.,-.1),(4.1,0.),(4.,.1),(0.,.1),(-.1,0.))",
       "(IFCLINEINDEX((1,2)),IFCARCINDEX((2,3,4)),IFCLINEINDEX((4,5)),IFCARCINDEX((5,6,1)))", {0, 5, 0});
  wall("circle", "((.3,0.),(0.,.3),(-.3,0.),(0.,-.3))", "(IFCARCINDEX((1,2,3)),IFCARCINDEX((3,4,1)))", {1, 8, 0});
  const MapImport imported = import(building);
  check_box(element(imported, "plain"), 0, 1, 2, 1.2);
  check_box(element(imported, "lines"), 0, 2, 2, 2.2);
  const ImportedElement& round = element(imported, "round ends");
  CHECK(area_m2(round) == Approx(0.8 + kPi * 0.01).margin(1e-3));
  CHECK((box_of(round).max() - Point(4.1, 5.1)).norm() < 1e-3);
  REQUIRE(element(imported, "circle").circles.size() == 1);
  CHECK(element(imported, "circle").circles[0].radius_m == Approx(0.3).margin(1e-9));
}

TEST_CASE("curved walls are as round as their circles, whatever way their parts are written") {
  const double radius_m = GENERATE(5.0, 60.0);
  const std::string same = GENERATE(".T.", ".F.");
  CAPTURE(radius_m, same);
  DrawnBuilding building;
  const auto number = [](double value) { return std::to_string(value); };
  const auto point = [&](double x, double y) {
    return ref(building.add("IFCCARTESIANPOINT", "(" + number(x) + "," + number(y) + ")"));
  };
  const auto arc = [&](double r, const std::string& sense) {
    const int place = building.add("IFCAXIS2PLACEMENT2D", point(0, 0) + ",$");
    const int circle = building.add("IFCCIRCLE", ref(place) + "," + number(r));
    const bool forward = sense == ".T.";
    return building.add("IFCTRIMMEDCURVE", ref(circle) + ",(IFCPARAMETERVALUE(" + number(forward ? 0 : kPi / 2) +
                                               ")),(" + (forward ? point(0, r) : point(r, 0)) + ")," + sense +
                                               ",.PARAMETER.");
  };
  const auto line = [&](double x0, double y0, double x1, double y1) {
    return building.add("IFCPOLYLINE", "(" + point(x0, y0) + "," + point(x1, y1) + ")");
  };
  const double in = radius_m - 0.1, out = radius_m + 0.1;
  std::string segments;
  for (const int part : {arc(out, ".T."), line(0, out, 0, in), arc(in, ".F."), line(in, 0, out, 0)})
    segments += (segments.empty() ? "(" : ",") +
                ref(building.add("IFCCOMPOSITECURVESEGMENT", ".CONTINUOUS.," + same + "," + ref(part)));
  const int curve = building.add("IFCCOMPOSITECURVE", segments + "),.F.");
  building.add_item("IFCWALL", "curved",
                    building.extruded(building.add("IFCARBITRARYCLOSEDPROFILEDEF", ".AREA.,$," + ref(curve))));
  const ImportedElement wall = element(import(building), "curved");
  CHECK(area_m2(wall) == Approx(kPi / 4 * (out * out - in * in)).epsilon(0.003));
  for (const Segment& s : wall.outline)
    if (s.length_m() > 0.21 || radius_m < 10) {
      const double r = s.midpoint().norm();
      if (std::abs(r - radius_m) > 0.05) CHECK(std::min(std::abs(r - in), std::abs(r - out)) < 0.005);
    }
}

TEST_CASE("splines are themselves, and not their control points") {
  DrawnBuilding building;
  const auto point = [&](const char* xy) { return ref(building.add("IFCCARTESIANPOINT", xy)); };
  const int spline = building.add("IFCBSPLINECURVEWITHKNOTS",
                                  "3,(" + point("(0.,0.)") + "," + point("(1.,1.)") + "," + point("(3.,1.)") + "," +
                                      point("(4.,0.)") + "),.UNSPECIFIED.,.F.,.F.,(4,4),(0.,1.),.UNSPECIFIED.");
  const int line = building.add("IFCPOLYLINE", "(" + point("(4.,0.)") + "," + point("(4.,-1.)") + "," +
                                                   point("(0.,-1.)") + "," + point("(0.,0.)") + ")");
  const int curve =
      building.add("IFCCOMPOSITECURVE",
                   "(" + ref(building.add("IFCCOMPOSITECURVESEGMENT", ".CONTINUOUS.,.T.," + ref(spline))) + "," +
                       ref(building.add("IFCCOMPOSITECURVESEGMENT", ".CONTINUOUS.,.T.," + ref(line))) + "),.F.");
  building.add_item("IFCWALL", "wave",
                    building.extruded(building.add("IFCARBITRARYCLOSEDPROFILEDEF", ".AREA.,$," + ref(curve))));
  const ImportedElement wave = element(import(building), "wave");
  CHECK(area_m2(wave) == Approx(4 + 2.1).epsilon(0.003));  // of the Bezier curve, by integration
  CHECK(box_of(wave).max().y() == Approx(0.75).margin(0.003));
}

TEST_CASE("tapered extrusions are cut where they are as wide as there") {
  DrawnBuilding building;
  const auto rectangle = [&](const char* sides) {
    return ref(building.add("IFCRECTANGLEPROFILEDEF", std::string(".AREA.,$,$,") + sides));
  };
  const int origin = building.add("IFCCARTESIANPOINT", "(0.,0.,0.)"), up = building.add("IFCDIRECTION", "(0.,0.,1.)");
  const std::string place = ref(building.add("IFCAXIS2PLACEMENT3D", ref(origin) + ",$,$"));
  const auto tapered = [&](const std::string& low, const std::string& high) {
    return building.add("IFCEXTRUDEDAREASOLIDTAPERED", low + "," + place + "," + ref(up) + ",3.," + high);
  };
  building.add_item("IFCWALL", "tapered", tapered(rectangle("4.,.4"), rectangle("4.,.1")));
  building.add_item("IFCWALL", "odd",
                    tapered(rectangle("4.,.4"), ref(building.add("IFCCIRCLEPROFILEDEF", ".AREA.,$,$,.2"))));
  const MapImport imported = import(building);
  check_box(element(imported, "tapered"), -2, -0.15, 2, 0.15);  // at a third of its height
  CHECK(element(imported, "odd").status == ImportStatus::unreadable);
  CHECK_THAT(element(imported, "odd").reason, Contains("do not match"));
}

namespace {

/// A cylinder of radius 0.25 m and height 3 m around (1, 2), as IfcAdvancedBrep has it, on another surface if so
/// wanted.
int advanced_cylinder(DrawnBuilding& building, bool with_seam, const std::string& side_surface = "") {
  const auto add = [&](const char* type, const std::string& arguments) { return ref(building.add(type, arguments)); };
  const auto point = [&](const char* xyz) { return add("IFCCARTESIANPOINT", xyz); };
  const auto axes = [&](const char* xyz) { return add("IFCAXIS2PLACEMENT3D", point(xyz) + ",$,$"); };
  const std::string low = axes("(1.,2.,0.)"), high = axes("(1.,2.,3.)");
  const std::string v0 = add("IFCVERTEXPOINT", point("(1.25,2.,0.)")),
                    v1 = add("IFCVERTEXPOINT", point("(1.25,2.,3.)"));
  const std::string e0 = add("IFCEDGECURVE", v0 + "," + v0 + "," + add("IFCCIRCLE", low + ",.25") + ",.T.");
  const std::string e1 = add("IFCEDGECURVE", v1 + "," + v1 + "," + add("IFCCIRCLE", high + ",.25") + ",.T.");
  const std::string up = add("IFCVECTOR", add("IFCDIRECTION", "(0.,0.,1.)") + ",1.");
  const std::string seam =
      add("IFCEDGECURVE", v0 + "," + v1 + "," + add("IFCLINE", point("(1.25,2.,0.)") + "," + up) + ",.T.");
  const auto way = [&](const std::string& edge, const char* sense) {
    return add("IFCORIENTEDEDGE", "*,*," + edge + "," + sense);
  };
  const auto bound = [&](const std::string& edges) {
    return add("IFCFACEBOUND", add("IFCEDGELOOP", "(" + edges + ")") + ",.T.");
  };
  const auto face = [&](const std::string& bounds, const std::string& surface) {
    return add("IFCADVANCEDFACE", "(" + bounds + ")," + surface + ",.T.");
  };
  const std::string around =
      side_surface.empty() ? add("IFCCYLINDRICALSURFACE", low + ",.25") : add(side_surface.c_str(), low + ",.25");
  const std::string side =
      with_seam ? bound(way(e0, ".T.") + "," + way(seam, ".T.") + "," + way(e1, ".F.") + "," + way(seam, ".F."))
                : bound(way(e0, ".T.")) + "," + bound(way(e1, ".T."));
  const std::string faces = face(side, around) + "," + face(bound(way(e0, ".F.")), add("IFCPLANE", low)) + "," +
                            face(bound(way(e1, ".T.")), add("IFCPLANE", high));
  return building.add("IFCADVANCEDBREP", add("IFCCLOSEDSHELL", "(" + faces + ")"));
}

}  // namespace

TEST_CASE("advanced breps of planes and cylinders come in, others are named with their surface") {
  DrawnBuilding building;
  building.add_item("IFCCOLUMN", "with seam", advanced_cylinder(building, true));
  building.add_item("IFCWALL", "ball", advanced_cylinder(building, true, "IFCSPHERICALSURFACE"));
  const MapImport imported = import(building);
  DrawnBuilding seamless;
  seamless.add_item("IFCCOLUMN", "without seam", advanced_cylinder(seamless, false));
  for (const ImportedElement& column : {element(imported, "with seam"), element(import(seamless), "without seam")}) {
    INFO(column.id << ": " << column.reason);
    REQUIRE(column.circles.size() == 1);
    CHECK((column.circles[0].center - Point(1, 2)).norm() < 1e-9);
    CHECK(column.circles[0].radius_m == Approx(0.25).margin(1e-9));
  }
  CHECK(element(imported, "ball").status == ImportStatus::unreadable);
  CHECK_THAT(element(imported, "ball").reason,
             Contains("IfcAdvancedBrep: a face on an ") && Contains("which is not cut"));
}

TEST_CASE("blocks and cylinders of solid modelling come in") {
  DrawnBuilding building;
  const int origin = building.add("IFCCARTESIANPOINT", "(1.,2.,0.)");
  const std::string place = ref(building.add("IFCAXIS2PLACEMENT3D", ref(origin) + ",$,$"));
  const int block = building.add("IFCBLOCK", place + ",4.,.2,3.");
  building.add_item("IFCWALL", "block", building.add("IFCCSGSOLID", ref(block)));
  building.add_item("IFCCOLUMN", "cylinder",
                    building.add("IFCCSGSOLID", ref(building.add("IFCRIGHTCIRCULARCYLINDER", place + ",3.,.25"))));
  building.add_item("IFCCOLUMN", "ball", building.add("IFCCSGSOLID", ref(building.add("IFCSPHERE", place + ",1."))));
  const MapImport imported = import(building);
  check_box(element(imported, "block"), 1, 2, 5, 2.2);
  REQUIRE(element(imported, "cylinder").circles.size() == 1);
  CHECK((element(imported, "cylinder").circles[0].center - Point(1, 2)).norm() < 1e-9);
  CHECK(element(imported, "cylinder").circles[0].radius_m == Approx(0.25));
  CHECK(element(imported, "ball").status == ImportStatus::unreadable);
  CHECK_THAT(element(imported, "ball").reason, Contains("IfcSphere"));
}

TEST_CASE("a repeated thing may be scaled and mirrored") {
  DrawnBuilding building;
  const int source = building.extruded(building.add("IFCRECTANGLEPROFILEDEF", ".AREA.,$,$,2.,.2"), {1, 0, 0});
  const int body =
      building.add("IFCSHAPEREPRESENTATION", ref(building.context()) + ",'Body','SweptSolid',(" + ref(source) + ")");
  const int origin = building.add("IFCCARTESIANPOINT", "(0.,0.,0.)");
  const int axes = building.add("IFCAXIS2PLACEMENT3D", ref(origin) + ",$,$");
  const std::string map = ref(building.add("IFCREPRESENTATIONMAP", ref(axes) + "," + ref(body)));
  const auto repeat = [&](const char* name, const char* type, const std::string& arguments) {
    building.add_item("IFCWALL", name, building.add("IFCMAPPEDITEM", map + "," + ref(building.add(type, arguments))));
  };
  const auto at = [&](const char* xyz) { return ref(building.add("IFCCARTESIANPOINT", xyz)); };
  const auto way = [&](const char* xyz) { return ref(building.add("IFCDIRECTION", xyz)); };
  repeat("twice", "IFCCARTESIANTRANSFORMATIONOPERATOR3D", "$,$," + at("(0.,2.,0.)") + ",2.,$");
  repeat("mirrored", "IFCCARTESIANTRANSFORMATIONOPERATOR3D",
         way("(-1.,0.,0.)") + "," + way("(0.,1.,0.)") + "," + at("(0.,4.,0.)") + ",1.," + way("(0.,0.,1.)"));
  repeat("uneven", "IFCCARTESIANTRANSFORMATIONOPERATOR3DNONUNIFORM", "$,$," + at("(0.,6.,0.)") + ",2.,$,3.,1.");
  const MapImport imported = import(building);
  check_box(element(imported, "twice"), 0, 1.8, 4, 2.2);
  check_box(element(imported, "mirrored"), -2, 3.9, 0, 4.1);
  check_box(element(imported, "uneven"), 0, 5.7, 4, 6.3);
}

TEST_CASE("a map conversion is in the unit of its map") {
  const std::string map_unit = GENERATE("metre", "none", "millimetre");
  CAPTURE(map_unit);
  DrawnBuilding building(Pose2(), "mm");
  building.add_wall("wall", {0, 0, 0}, 4, 0.2);
  const std::string prefix = map_unit == "metre" ? "$" : ".MILLI.";
  const int unit = building.add("IFCSIUNIT", "*,.LENGTHUNIT.," + prefix + ",.METRE.");
  const int crs = building.add("IFCPROJECTEDCRS", "'EPSG:28992',$,$,$,$,$," + (map_unit == "none" ? "$" : ref(unit)));
  const std::string place = map_unit == "metre" ? "155000.,463000.,3.5" : "155000000.,463000000.,3500.";
  building.add("IFCMAPCONVERSION", ref(building.context()) + "," + ref(crs) + "," + place + ",0.8,0.6,$");
  const auto georeference = import(building).map->origin().georeference;
  REQUIRE(georeference);
  CHECK(georeference->crs == "EPSG:28992");
  CHECK(georeference->eastings_m == Approx(155000));
  CHECK(georeference->northings_m == Approx(463000));
  CHECK(georeference->height_m == Approx(3.5));
  CHECK(georeference->heading_rad == Approx(std::atan2(0.6, 0.8)));
}

TEST_CASE("a building in national coordinates comes in, and may be moved near to its origin") {
  const Pose2 T_grid_building(412000.25, 5654000.5, 0.3);  // UTM
  DrawnBuilding building(T_grid_building, "mm");
  building.add_wall("wall", {0, 0, 0}, 4, 0.2);
  building.add_wall("stem", {0, 1.1, kPi / 2}, 2, 0.2);
  CHECK_THROWS_WITH(import(building, {{"origin_x_m", 1}}), Contains("origin_x_m") && Contains("wall"));
  const MapImport imported = import(building, {{"origin_x_m", 412000}, {"origin_y_m", 5654000}});
  REQUIRE(element(imported, "wall").status == ImportStatus::imported);
  const MapImport near = [] {
    DrawnBuilding same(Pose2(0.25, 0.5, 0.3), "mm");
    same.add_wall("wall", {0, 0, 0}, 4, 0.2);
    same.add_wall("stem", {0, 1.1, kPi / 2}, 2, 0.2);
    return import(same);
  }();
  REQUIRE(imported.map->features().size() == near.map->features().size());
  for (std::size_t k = 0; k < near.map->features().size(); ++k)
    CHECK((anchor_of(imported.map->features()[k].geometry) - anchor_of(near.map->features()[k].geometry)).norm() <
          1e-5);
}

TEST_CASE("a solid thing without a body is told by name, and so is why nothing came in") {
  DrawnBuilding building;
  building.add_wall("wall", {0, 0, 0}, 4, 0.2);
  building.add_whole("IFCWALL", "bodiless", {});
  const MapImport imported = import(building);
  CHECK(element(imported, "bodiless").status == ImportStatus::unreadable);
  CHECK(element(imported, "bodiless").reason == "it has no body, and no parts that have one");
  CHECK(says(imported,
             "cannot be read: IfcWall, it has no body, and no parts that have one: " + DrawnBuilding::id("bodiless")));
  DrawnBuilding unreadable;
  const int origin = unreadable.add("IFCCARTESIANPOINT", "(0.,0.,0.)");
  const int axes = unreadable.add("IFCAXIS2PLACEMENT3D", ref(origin) + ",$,$");
  unreadable.add_item("IFCWALL", "ball", unreadable.add("IFCSPHERE", ref(axes) + ",1."));
  CHECK_THROWS_WITH(import(unreadable), Contains("nothing of the building is there") && Contains("IfcSphere") &&
                                            Contains(DrawnBuilding::id("ball")));
}

TEST_CASE("sheets thinner than the gaps that are closed keep their two sides") {
  const double thickness_m = GENERATE(0.009, 0.005, 0.003);
  DrawnBuilding building;
  building.add_box("IFCPLATE", "steel sheet", {0, 0, 0.3}, 2, thickness_m);
  building.add_wall("wall", {0, 3, 0}, 4, 0.2);
  const MapImport imported = import(building);
  const auto faces = features_of(*imported.map, "steel sheet", GeometryKind::segment);
  REQUIRE(faces.size() == 2);
  for (const MapFeature* face : faces) CHECK(std::get<Segment>(face->geometry).length_m() == Approx(2).margin(0.01));
}

TEST_CASE("sheets so thin that both sides are one place bring nothing down") {
  const double thickness_m = GENERATE(0.0021, 0.002, 0.0019, 0.001, 0.0001);
  CAPTURE(thickness_m);
  DrawnBuilding building;
  building.add_box("IFCPLATE", "steel sheet", {0, 0, GENERATE(0.0, 0.3)}, 2, thickness_m);
  building.add_wall("wall", {0, 3, 0}, 4, 0.2);
  const MapImport imported = import(building);
  CHECK(features_of(*imported.map, "wall", GeometryKind::segment).size() == 4);
  const bool is_there = !features_of(*imported.map, "steel sheet", GeometryKind::segment).empty();
  if (!is_there) CHECK_THAT(element(imported, "steel sheet").reason, Contains("thinner than"));
}

TEST_CASE("names are decoded as STEP encodes them") {
  DrawnBuilding building;
  building.add_wall("W\\X2\\00E4\\X0\\nd \\X\\E9 \\S\\d \\X4\\0001F600\\X0\\ it''s", {0, 0, 0}, 4, 0.2);
  const MapImport imported = import(building);
  REQUIRE(imported.map->objects().size() == 1);
  CHECK(imported.map->objects()[0].notes.name == "Wänd é ä \xF0\x9F\x98\x80 it's");
}
