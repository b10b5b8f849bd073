#pragma once

#include <opal/common/geometry.hpp>
#include <opal/map/map_numbers.hpp>
#include <opal/map/storeys.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal {

struct MapDraft;
struct MapSource;

/// What a source says of a thing beyond its place and its looks. Nothing of it is used to localize.
struct ObjectNotes {
  std::string name = {};                     ///< for people
  std::string source_class = {};             ///< "IfcWallStandardCase", the layer of a drawing
  std::string storey = {};                   ///< name of the storey that the source puts it on
  double thickness_m = 0;                    ///< of a wall's layers; 0: not said
  double width_m = 0;                        ///< of a door or window; 0: not said
  std::optional<Segment> axis = {};          ///< a wall's reference line; no side is the visible one
  std::vector<std::string> merged_ids = {};  ///< of things that the source has at the same place once more

  /// True if all that is said is the same.
  OPAL_EXPORT bool operator==(const ObjectNotes& other) const;
};

/// A thing in the building that the map names: a wall, a column, a door.
struct MapObject {
  std::string id;    ///< IRI or local name, unique in the map (for imported buildings the IFC GlobalId)
  std::string type;  ///< open: "opal:Wall", "opal:Column", "acme:Kiosk"; "Wall" is taken as "opal:Wall"
  /// All sensors'; may be empty. `make` fills it in.
  std::vector<MapFeatureNumber> features = {};
  ObjectNotes notes = {};  ///< what the source says beside; may be empty
};

/// One geometric primitive through which an object can be perceived, in the `map` frame.
struct MapFeature {
  std::string id;               ///< of the geometry; unique in the map for one sensor
  MapObjectNumber object = {};  ///< that it belongs to
  std::string type;             ///< what a detector must produce to see it: "opal:Wall", "opal:Corner", "opal:Column"
  std::string sensor;           ///< id of the sensor that can perceive it; empty: none does
  Geometry geometry;            ///< shape and place [m, rad]; frame `map`
  double position_sigma_m = 0;  ///< how far the building may be from the map here; 0: the map does not say
  double existence = 1;         ///< probability that it is really there
  /// Topology: ids of the points that make the geometry (a segment's begin and end, a corner's point, a circle's
  /// centre; a point feature's own id). Features that share a point share its id. Left empty, `make` names points
  /// after the feature: "w1/begin", "w1/end", "k1/point", "c1/center".
  std::vector<std::string> points = {};
  /// Id of the ObjectFeatureRepresentation node, which the features of one object and sensor may share; may be empty.
  std::string representation = {};
};

/// A relation between features that the map itself names (thesis 4.4.1).
struct MapPattern {
  std::string id;                             ///< IRI or local name; unique in the map
  std::string pattern_template;               ///< the template's type name
  std::vector<MapFeatureNumber> features;     ///< in the template's slot order
  std::vector<std::string> subpatterns = {};  ///< ids of the patterns that it is made of
  std::vector<double> dimensions = {};        ///< the template's invariants; the last ones, or all, may be left out
  std::string place = {};  ///< where it stands, for messages: "hall.jsonld: /@graph/12"; `make` and `read` fill it in
};

/// Where a map that this one was joined of lies in it: scaled in its own frame first, then moved.
struct MapPlacement {
  std::string id;      ///< what came from that map is named "ID/..."
  Pose2 T_map_source;  ///< where the source's frame lies in this map, after scaling
  Point scale{1, 1};   ///< along the source's x and y axis; below zero: mirrored

  /// A point of the source [m] in this map.
  Point to_map(const Point& p_source) const { return T_map_source * Point(scale.cwiseProduct(p_source)); }
  /// True if the source was neither stretched nor mirrored.
  bool is_rigid() const { return scale.x() == 1 && scale.y() == 1; }
};

/// Where a map lies on the Earth, if its source says so in earnest (IfcMapConversion).
struct Georeference {
  std::string crs;         ///< name of the projected coordinate system: "EPSG:28992"
  double eastings_m = 0;   ///< of the map's origin
  double northings_m = 0;  ///< of the map's origin
  double height_m = 0;     ///< of the map's origin, above the datum of the coordinate system
  double heading_rad = 0;  ///< of the map's x axis, counter-clockwise from east
};

/// What a map says about how it was made.
struct MapOrigin {
  /// How much thicker than they are walls stand in the source (both sides together); faces have been moved back by half
  /// of it, so nothing has to be done about it, but they are uncertain by about a quarter of it.
  double smear_m = 0;
  std::vector<MapPlacement> placements = {};      ///< in order of id
  std::optional<double> cut_height_m = {};        ///< where a building model was cut, in its coordinates
  std::string storey = {};                        ///< name of the level that this belongs to
  double widest_door_m = 0;                       ///< straight things up to this length may be open doors; 0: not said
  std::optional<double> north_rad = {};           ///< heading of true north
  std::optional<Georeference> georeference = {};  ///< none: the source does not say
  std::vector<MapBuilding> buildings = {};        ///< of the storeys, in order of id
  std::vector<MapStorey> storeys = {};            ///< sheets, in order of id; none: the map is one storey
  std::vector<MapConnection> connections = {};    ///< lifts and stairs, in order of id
};

/// The static building, as a typed immutable view of a JSON-LD graph. Frame: `map`; units: metres, radians.
///
/// A graph has no order, so objects and patterns stand in order of id and features in order of id and sensor,
/// whatever the order in which they were given: the same building gives the same map, positions included. Numbers
/// inside ids count as numbers ("wall-2" before "wall-10").
class OPAL_EXPORT SemanticMap {
 public:
  /// Reads and checks a whole document; all of it or an error, never less map than the document holds.
  /// @throws MapError naming the file, the JSON pointer, what was found and what was expected.
  static std::shared_ptr<const SemanticMap> read(const std::string& path);
  /// The same for a document in memory.
  /// @param text  a whole JSON-LD document.
  /// @param name  stands for the file in error messages, and names the map if the document does not.
  static std::shared_ptr<const SemanticMap> parse(const std::string& text, const std::string& name);
  /// Takes a map that was built in memory (an importer, a test); same checks. Objects and features come in any
  /// order and refer to each other by their position in the arguments.
  static std::shared_ptr<const SemanticMap> make(std::string name, std::vector<MapObject> objects,
                                                 std::vector<MapFeature> features,
                                                 std::vector<MapPattern> patterns = {}, MapOrigin origin = {});

  /// The same map with these patterns instead of its own.
  std::shared_ptr<const SemanticMap> with_patterns(std::vector<MapPattern> patterns) const;
  /// The same map with other contents, which refer to each other as in `make`; same checks. Its prefixes and what Opal
  /// makes no use of stay, and these are added.
  std::shared_ptr<const SemanticMap> with_contents(std::vector<MapObject> objects, std::vector<MapFeature> features,
                                                   std::vector<MapPattern> patterns,
                                                   const std::map<std::string, std::string>& more_prefixes = {},
                                                   const nlohmann::json& more_unused = nlohmann::json::array()) const;

  const std::string& name() const { return name_; }                      ///< as the document or its maker says
  const std::vector<MapObject>& objects() const { return objects_; }     ///< by id
  const std::vector<MapFeature>& features() const { return features_; }  ///< by id and sensor
  const std::vector<MapPattern>& patterns() const { return patterns_; }  ///< by id; empty without a layer
  /// One of the objects.
  const MapObject& object(MapObjectNumber number) const { return objects_[number.number()]; }
  /// One of the features.
  const MapFeature& feature(MapFeatureNumber number) const { return features_[number.number()]; }
  const MapOrigin& origin() const { return origin_; }  ///< how the map was made

  /// Prefixes in the names of other makers ("acme:Kiosk") and the IRIs that they stand for, as the document's context
  /// defines them. Names in memory have their prefix, so that they are those that plugins register.
  const std::map<std::string, std::string>& prefixes() const { return prefixes_; }

  /// What the document says in other vocabularies, or about geometry that no representation uses: an array of node
  /// objects in expanded JSON-LD. Opal makes no use of it, reports it (map_check.hpp) and writes it back.
  const nlohmann::json& unused() const { return unused_; }

  /// The map as a JSON-LD document (compact terms of maps/context/opal.jsonld); reading it back gives this map.
  nlohmann::ordered_json to_json_ld() const;

 private:
  explicit SemanticMap(MapDraft&& checked);
  static std::shared_ptr<const SemanticMap> from_document(const nlohmann::json& document, const MapSource& source);
  static std::shared_ptr<const SemanticMap> finish(MapDraft draft);

  std::string name_;
  std::vector<MapObject> objects_;
  std::vector<MapFeature> features_;
  std::vector<MapPattern> patterns_;
  MapOrigin origin_;
  std::map<std::string, std::string> prefixes_;
  nlohmann::json unused_;
};

}  // namespace opal
