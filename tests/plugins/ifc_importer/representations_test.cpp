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
