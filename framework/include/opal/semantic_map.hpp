#pragma once

#include <opal/geometry.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace opal {

/// A thing in the building that the map names: a wall, a column, a door.
struct MapObject {
  std::string id;    ///< IRI or local name, unique in the map (for imported buildings the IFC GlobalId)
  std::string type;  ///< open: "opal:Wall", "opal:Column", ...
  std::vector<int> features;  ///< positions in SemanticMap::features(), all sensors
};

/// One geometric primitive through which an object can be perceived, in the `map` frame.
struct MapFeature {
  std::string id;
  int object = -1;          ///< position in SemanticMap::objects()
  std::string type;         ///< what a detector must produce to see it: "opal:Wall", "opal:Corner", "opal:Column"
  std::string sensor;       ///< id of the sensor that can perceive it
  Geometry geometry;
  double position_sigma_m = 0;  ///< how far the building may be from the map here; 0: the map does not say
  double existence = 1;         ///< probability that it is really there
  /// Topology: ids of the points that make the geometry (a segment's begin and end, a corner's point). Features
  /// that share a point share its id.
  std::vector<std::string> points;
};

/// A relation between features that the map itself names (thesis 4.4.1).
struct MapPattern {
  std::string id;
  std::string pattern_template;        ///< the template's type name
  std::vector<int> features;           ///< positions in SemanticMap::features(), in the template's slot order
  std::vector<std::string> subpatterns;
  std::vector<double> dimensions;      ///< the template's invariants
};

/// The static building, as a typed immutable view of a JSON-LD graph. Frame: `map`; units: metres, radians.
class OPAL_EXPORT SemanticMap {
 public:
  /// Reads and checks a whole document; all of it or an error, never less map than the document holds.
  /// @throws MapError naming the file, the JSON pointer, what was found and what was expected.
  static std::shared_ptr<const SemanticMap> read(const std::string& path);
  static std::shared_ptr<const SemanticMap> parse(const std::string& text, const std::string& name);
  /// Takes a map that was built in memory (an importer, a test); same checks.
  static std::shared_ptr<const SemanticMap> make(std::string name, std::vector<MapObject> objects,
                                                 std::vector<MapFeature> features,
                                                 std::vector<MapPattern> patterns = {});

  const std::string& name() const { return name_; }
  const std::vector<MapObject>& objects() const { return objects_; }
  const std::vector<MapFeature>& features() const { return features_; }
  const std::vector<MapPattern>& patterns() const { return patterns_; }

  /// The map as a JSON-LD document (compact terms of maps/context/opal.jsonld); reading it back gives this map.
  nlohmann::ordered_json to_json_ld() const;

 private:
  SemanticMap() = default;
  std::string name_;
  std::vector<MapObject> objects_;
  std::vector<MapFeature> features_;
  std::vector<MapPattern> patterns_;
};

}  // namespace opal
