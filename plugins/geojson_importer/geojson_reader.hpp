#pragma once

#include <opal/common/geometry.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace opal::geojson_importer {

/// A ring without its last position, which repeats the first.
using Ring = std::vector<Point>;

/// Everything that a geometry of GeoJSON is made of; in the coordinates of the file (x or longitude first).
struct Shapes {
  std::vector<Point> points;
  std::vector<std::vector<Point>> lines;
  std::vector<std::vector<Ring>> polygons;  ///< outer ring, holes
};

/// Calls visit(point) for every position of Shapes, constant or not.
template <class AnyShapes, class Visit>
void visit_positions(AnyShapes& shapes, Visit&& visit) {
  for (auto& p : shapes.points) visit(p);
  for (auto& line : shapes.lines)
    for (auto& p : line) visit(p);
  for (auto& polygon : shapes.polygons)
    for (auto& ring : polygon)
      for (auto& p : ring) visit(p);
}

struct Feature {
  std::string id;        ///< "feature-3" if it has none
  std::string geometry;  ///< "Polygon"; "" if it has none
  nlohmann::json properties = nlohmann::json::object();
  Shapes shapes;
  std::string damage;                    ///< a whole message, if it is damaged: a map must not be made of it
  std::string type = {};                 ///< what becomes of it: an object type, kLeaveOut, or nothing
  std::string said_by = {};              ///< "room=toilets", if words of it say the type and no rule; else empty
  bool is_used = false;                  ///< something becomes of it on some level
  std::vector<std::string> levels = {};  ///< as find_levels() has them; none: it does not say, and is on all of them
};

/// The property of this name; else one whose name differs in upper and lower case only; end() if there is none.
nlohmann::json::const_iterator find_property(const Feature& feature, const std::string& name);

/// A property that is a text, or a number as it is written; "" if it is neither. Upper and lower case of its name are
/// the same.
std::string text_or_number(const Feature& feature, const std::string& property);

struct FeatureCollection {
  std::string name;  ///< empty: the file does not say
  std::vector<Feature> features;
  std::string crs;                                    ///< name in the member `crs` of 2008; empty: there is none
  std::map<std::string, std::string> level_of_name;   ///< what else than by `level` a level is called
  std::map<std::string, std::string> label_of_level;  ///< for people, where `level` is a number of a level with a name
  std::string level_property;                         ///< what else than `level` says the levels; empty: nothing else
  std::vector<std::string> notes;                     ///< sentences about the reading
};

/// Reads GeoJSON (RFC 7946): a FeatureCollection, or one Feature.
/// @throws MapError "PATH: POINTER: what was found, what was expected".
FeatureCollection read_geojson(const std::string& path);

}  // namespace opal::geojson_importer
