#include "drawn_building.hpp"

#include <opal/plugin/plugin_registry.hpp>

#include <catch2/catch.hpp>

#include <sstream>

namespace opal {
namespace {

std::string listed(const std::vector<int>& numbers) {
  std::string list;
  for (const int number : numbers) list += (list.empty() ? "" : ",") + ref(number);
  return "(" + list + ")";
}

std::string real(double value) {
  std::ostringstream text;
  text.precision(15);
  text << value;
  const std::string digits = text.str();
  return digits.find_first_of(".e") == std::string::npos ? digits + "." : digits;
}

}  // namespace

DrawnBuilding::DrawnBuilding(const Pose2& T_world_building, const std::string& unit) {
  int length = add("IFCSIUNIT", std::string("*,.LENGTHUNIT.,") + (unit == "mm" ? ".MILLI." : "$") + ",.METRE.");
  if (unit == "mm") unit_m_ = 0.001;
  if (unit == "ft") {
    unit_m_ = 0.3048;
    const int exponents = add("IFCDIMENSIONALEXPONENTS", "1,0,0,0,0,0,0");
    const int factor = add("IFCMEASUREWITHUNIT", "IFCLENGTHMEASURE(0.3048)," + ref(length));
    length = add("IFCCONVERSIONBASEDUNIT", ref(exponents) + ",.LENGTHUNIT.,'FOOT'," + ref(factor));
  }
  const int angle = add("IFCSIUNIT", "*,.PLANEANGLEUNIT.,$,.RADIAN.");
  const int units = add("IFCUNITASSIGNMENT", listed({length, angle}));
  context_ = add("IFCGEOMETRICREPRESENTATIONCONTEXT", "$,'Model',3,1.E-5," + ref(axes(Pose2())) + ",$");
  add("IFCPROJECT", "'" + id("project") + "',$,'drawn',$,$,$,$," + listed({context_}) + "," + ref(units));
  site_ = placement(T_world_building, 0);
}

int DrawnBuilding::add(const std::string& type, const std::string& arguments) {
  lines_ += ref(++last_) + "=" + type + "(" + arguments + ");\n";
  return last_;
}

std::string DrawnBuilding::number(double metres) const { return real(metres / unit_m_); }

int DrawnBuilding::point(double x_m, double y_m, double z_m) {
  return add("IFCCARTESIANPOINT", "(" + number(x_m) + "," + number(y_m) + "," + number(z_m) + ")");
}

int DrawnBuilding::direction(double x, double y, double z) {
  return add("IFCDIRECTION", "(" + real(x) + "," + real(y) + "," + real(z) + ")");
}

int DrawnBuilding::axes(const Pose2& pose, double z_m) {
  const int origin = point(pose.x(), pose.y(), z_m), up = direction(0, 0, 1);
  const Point x = unit_vector(pose.heading_rad());
  return add("IFCAXIS2PLACEMENT3D", ref(origin) + "," + ref(up) + "," + ref(direction(x.x(), x.y(), 0)));
}

int DrawnBuilding::placement(const Pose2& pose, int relative_to) {
  const int position = axes(pose);
  return add("IFCLOCALPLACEMENT", (relative_to ? ref(relative_to) : "$") + "," + ref(position));
}

int DrawnBuilding::extruded(int profile, int position, double height_m) {
  const int up = direction(0, 0, 1);
  return add("IFCEXTRUDEDAREASOLID", ref(profile) + "," + ref(position) + "," + ref(up) + "," + number(height_m));
}

int DrawnBuilding::box_solid(const Pose2& pose, double length_m, double width_m, double height_m) {
  const int profile = add("IFCRECTANGLEPROFILEDEF", ".AREA.,$,$," + number(length_m) + "," + number(width_m));
  return extruded(profile, axes(pose), height_m);
}

int DrawnBuilding::shape(const std::vector<int>& solids) {
  const int body = add("IFCSHAPEREPRESENTATION", ref(context_) + ",'Body','SweptSolid'," + listed(solids));
  return add("IFCPRODUCTDEFINITIONSHAPE", "$,$," + listed({body}));
}

int DrawnBuilding::add_thing(const std::string& type, const std::string& name, int shape,
                             const std::string& further_arguments, const Pose2& pose) {
  const int place = placement(pose, site_);
  things_.push_back(add(type, "'" + id(name) + "',$,'" + name + "',$,$," + ref(place) + "," +
                                  (shape ? ref(shape) : "$") + ",$" +
                                  (further_arguments.empty() ? "" : "," + further_arguments)));
  return things_.back();
}

int DrawnBuilding::add_box(const std::string& type, const std::string& name, const Pose2& pose, double length_m,
                           double width_m, const std::string& further_arguments, double height_m) {
  return add_thing(type, name, shape({box_solid(pose, length_m, width_m, height_m)}), further_arguments);
}

int DrawnBuilding::add_wall(const std::string& name, const Pose2& pose, double length_m, double thickness_m) {
  return add_box("IFCWALL", name, pose, length_m, thickness_m);
}

int DrawnBuilding::add_footing(const std::string& name, const Pose2& pose, double length_m, double thickness_m,
                               double depth_m) {
  const int profile = add("IFCRECTANGLEPROFILEDEF", ".AREA.,$,$," + number(length_m) + "," + number(thickness_m));
  return add_thing("IFCWALL", name, shape({extruded(profile, axes(pose, -depth_m), depth_m)}), "$");
}

int DrawnBuilding::add_column(const std::string& name, const Point& center, double radius_m) {
  const int profile = add("IFCCIRCLEPROFILEDEF", ".AREA.,$,$," + number(radius_m));
  return add_thing("IFCCOLUMN", name, shape({extruded(profile, axes(Pose2(center, 0)), 3)}), "$");
}

void DrawnBuilding::add_door(int wall, const std::string& name, const Pose2& pose, double width_m,
                             double wall_thickness_m) {
  const int hole = shape({box_solid(pose, width_m, wall_thickness_m, 2.1)});
  const int opening = add("IFCOPENINGELEMENT", "'" + id(name + "-hole") + "',$,$,$,$," +
                                                   ref(placement(Pose2(), site_)) + "," + ref(hole) + ",$,$");
  const double beside = width_m / 2 - 0.025;
  const std::vector<int> solids{box_solid(Pose2(-beside, 0, 0), 0.05, wall_thickness_m, 2.1),
                                box_solid(Pose2(beside, 0, 0), 0.05, wall_thickness_m, 2.1),
                                box_solid(Pose2(), width_m - 0.1, 0.04, 2.1)};
  const int door = add_thing("IFCDOOR", name, shape(solids), number(2.1) + "," + number(width_m) + ",$,$,$", pose);
  add("IFCRELVOIDSELEMENT", "'" + id(name + "-voids") + "',$,$,$," + ref(wall) + "," + ref(opening));
  add("IFCRELFILLSELEMENT", "'" + id(name + "-fills") + "',$,$,$," + ref(opening) + "," + ref(door));
}

void DrawnBuilding::add_whole(const std::string& type, const std::string& name, const std::vector<int>& parts) {
  const int whole = add_thing(type, name, 0, "$");
  add("IFCRELAGGREGATES", "'" + id(name + "-parts") + "',$,$,$," + ref(whole) + "," + listed(parts));
}

void DrawnBuilding::add_storey(const std::string& name, double elevation_m) {
  const int origin = point(0, 0, elevation_m);
  const int position = add("IFCAXIS2PLACEMENT3D", ref(origin) + ",$,$");
  const int place = add("IFCLOCALPLACEMENT", "$," + ref(position));
  add("IFCBUILDINGSTOREY",
      "'" + id(name) + "',$,'" + name + "',$,$," + ref(place) + ",$,$,.ELEMENT.," + number(elevation_m));
}

std::string DrawnBuilding::text(const std::string& schema) const {
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('drawn','',(''),(''),'','','');\n"
         "FILE_SCHEMA(('" +
         schema + "'));\nENDSEC;\nDATA;\n" + lines_ + "ENDSEC;\nEND-ISO-10303-21;\n";
}

std::string DrawnBuilding::id(const std::string& name) {
  std::string id = name;
  for (char& c : id)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  id.resize(22, '0');
  return id;
}

std::shared_ptr<const MapImporter> ifc_importer(const nlohmann::json& options) {
  static const PluginRegistry kRegistry = [] {
    PluginRegistry registry;
    registry.load(std::string(OPAL_PLUGIN_DIR) + "/ifc_importer.so");
    return registry;
  }();
  return kRegistry.make<MapImporter>("opal:IfcImporter", options);
}

MapImport import_text(const std::string& text, nlohmann::json options) {
  if (!options.contains("z_m") && !options.contains("storey")) options["z_m"] = 1;
  const IfcFile file(text);
  return ifc_importer(options)->import(file.path());
}

MapImport import(const DrawnBuilding& building, const nlohmann::json& options) {
  return import_text(building.text(), options);
}

const ImportedElement& element(const MapImport& imported, const std::string& name) {
  for (const ImportedElement& element : imported.elements)
    if (element.id == DrawnBuilding::id(name)) return element;
  FAIL("no element " << name);
  return imported.elements.front();
}

std::vector<const MapFeature*> features_of(const SemanticMap& map, const std::string& name, GeometryKind kind,
                                           bool seen) {
  std::vector<const MapFeature*> features;
  for (const MapFeature& feature : map.features())
    if (map.object(feature.object).id == DrawnBuilding::id(name) && kind_of(feature.geometry) == kind &&
        feature.sensor.empty() != seen)
      features.push_back(&feature);
  return features;
}

std::vector<const MapFeature*> all_of(const SemanticMap& map, GeometryKind kind) {
  std::vector<const MapFeature*> features;
  for (const MapFeature& feature : map.features())
    if (kind_of(feature.geometry) == kind && !feature.sensor.empty()) features.push_back(&feature);
  return features;
}

}  // namespace opal
