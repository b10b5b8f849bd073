#include <opal/map/semantic_map.hpp>

#include "map/document/map_notes.hpp"
#include "map/document/storeys_document.hpp"
#include "map/map_vocabulary.hpp"
#include "map/semantic_map_draft.hpp"

#include <set>
#include <unordered_set>

namespace opal {
namespace {

using Json = nlohmann::ordered_json;
using vocabulary::short_term;

/// Writes each geometry and each point in full where it is first met, and by its id after that.
class Writer {
 public:
  explicit Writer(const SemanticMap& map) : map_(map) {}

  Json document() {
    Json graph = Json::array();
    if (const Json node = map_node(); node.size() > 1) graph.push_back(node);
    for (const MapPlacement& placement : map_.origin().placements) graph.push_back(written(placement));
    write_storeys(map_.origin(), graph);
    for (const std::string& sensor : sensors()) graph.push_back({{"@id", sensor}, {"@type", "Sensor"}});
    for (const MapObject& object : map_.objects()) graph.push_back(written(object));
    for (const MapPattern& pattern : map_.patterns()) graph.push_back(written(pattern));
    for (const nlohmann::json& node : map_.unused()) graph.push_back(Json(node));
    return {{"@context", context()}, {"@graph", std::move(graph)}};
  }

 private:
  Json map_node() const {
    Json node = {{"@type", "SemanticMap"}};
    if (!map_.name().empty()) node["name"] = map_.name();
    if (map_.origin().smear_m != 0) node["smear_m"] = map_.origin().smear_m;
    write_notes(map_.origin(), node);
    return node;
  }

  static Json written(const MapPlacement& placement) {
    return {{"@id", placement.id},
            {"@type", "MapPlacement"},
            {"x", placement.T_map_source.x()},
            {"y", placement.T_map_source.y()},
            {"heading_rad", placement.T_map_source.heading_rad()},
            {"scale_x", placement.scale.x()},
            {"scale_y", placement.scale.y()}};
  }

  Json context() const {
    if (map_.prefixes().empty()) return vocabulary::kContextIri;
    return Json::array({vocabulary::kContextIri, Json(map_.prefixes())});
  }

  std::set<std::string> sensors() const {
    std::set<std::string> sensors;
    for (const MapFeature& feature : map_.features())
      if (!feature.sensor.empty()) sensors.insert(feature.sensor);
    return sensors;
  }

  Json written(const MapObject& object) {
    Json representations = Json::array();
    for (const MapFeatureNumber feature : object.features)
      representations.push_back(representation(map_.feature(feature)));
    Json type = short_term(object.type);
    if (object.features.empty() && !vocabulary::is_object_type(vocabulary::full_iri(object.type)))
      type = Json::array({type, "Element"});  // without representations nothing else says that it is an object
    Json node = {{"@id", object.id}, {"@type", type}};
    write_notes(object.notes, node);
    if (!representations.empty()) node["represented_by"] = std::move(representations);
    return node;
  }

  Json representation(const MapFeature& feature) {
    Json node = Json::object();
    if (!feature.representation.empty()) node["@id"] = feature.representation;
    node["@type"] = "ObjectFeatureRepresentation";
    if (!feature.sensor.empty()) node["perceivable_by"] = {{"@id", feature.sensor}};
    if (feature.type != vocabulary::default_feature_type(feature.geometry))
      node["feature_type"] = short_term(feature.type);
    node["represented_by"] = geometry(feature);
    return node;
  }

  Json geometry(const MapFeature& feature) {
    if (!geometries_.insert(feature.id).second) return {{"@id", feature.id}};
    Json node = shape(feature);
    if (feature.position_sigma_m != 0) node["position_sigma_m"] = feature.position_sigma_m;
    if (feature.existence != 1) node["existence"] = feature.existence;
    return node;
  }

  Json shape(const MapFeature& feature) {
    const std::string& id = feature.id;
    const std::vector<std::string>& points = feature.points;
    if (const auto* segment = std::get_if<Segment>(&feature.geometry))
      return {{"@id", id},
              {"@type", "LineSegment"},
              {"begin", point(points[0], segment->begin)},
              {"end", point(points[1], segment->end)}};
    if (const auto* corner = std::get_if<OrientedPoint>(&feature.geometry))
      return {{"@id", id},
              {"@type", "Corner"},
              {"point", point(points[0], corner->position)},
              {"heading_rad", corner->heading_rad},
              {"opening_rad", corner->opening_rad}};
    if (const auto* circle = std::get_if<Circle>(&feature.geometry))
      return {{"@id", id},
              {"@type", "Circle"},
              {"center", point(points[0], circle->center)},
              {"radius_m", circle->radius_m}};
    return point(id, std::get<Point>(feature.geometry));
  }

  Json point(const std::string& id, const Point& position) {
    if (!points_.insert(id).second) return {{"@id", id}};
    return {{"@id", id}, {"@type", "Point"}, {"x", position.x()}, {"y", position.y()}};
  }

  Json written(const MapPattern& pattern) const {
    Json members = Json::array();
    for (const MapFeatureNumber feature : pattern.features) members.push_back(map_.feature(feature).id);
    Json node = {{"@id", pattern.id}, {"@type", "FeaturePattern"}, {"template", short_term(pattern.pattern_template)}};
    const std::string& sensor = map_.feature(pattern.features.front()).sensor;
    if (several_sensors_see_a_member(pattern)) node["perceivable_by"] = {{"@id", sensor}};
    node["features"] = std::move(members);
    if (!pattern.subpatterns.empty()) node["subpatterns"] = pattern.subpatterns;
    if (!pattern.dimensions.empty()) node["dimensions"] = pattern.dimensions;
    return node;
  }

  bool several_sensors_see_a_member(const MapPattern& pattern) const {
    const std::vector<MapFeature>& features = map_.features();
    const int last = static_cast<int>(features.size()) - 1;
    for (const MapFeatureNumber member : pattern.features) {  // features are in order of id
      const int i = member.number();
      if ((i > 0 && features[i - 1].id == features[i].id) || (i < last && features[i + 1].id == features[i].id))
        return true;
    }
    return false;
  }

  const SemanticMap& map_;
  std::unordered_set<std::string> geometries_;
  std::unordered_set<std::string> points_;
};

}  // namespace

nlohmann::ordered_json SemanticMap::to_json_ld() const { return Writer(*this).document(); }

}  // namespace opal
