#include "map/document/semantic_map_reader.hpp"

#include "common/phrases.hpp"
#include "jsonld/context/iri.hpp"
#include "map/document/map_notes.hpp"
#include "map/document/semantic_map_unused.hpp"
#include "map/document/storeys_document.hpp"
#include "map/map_vocabulary.hpp"

#include <algorithm>

namespace opal {
namespace {

using namespace vocabulary;

class Reader {
 public:
  Reader(const Graph& graph, const std::string& source, const std::string& default_name)
      : graph_(graph), uses_(graph.nodes().size()) {
    draft_.source = source;
    draft_.name = default_name;
  }

  MapDraft draft() {
    for (const GraphNode& node : graph_.nodes()) check_words(node);
    for (const GraphNode& node : graph_.nodes()) read_map_name(node);
    for (const GraphNode& node : graph_.nodes())
      if (node.has_type(iri::kPlacement)) read_placement(node);
    read_storeys(graph_, uses_, draft_.origin);
    for (const GraphNode& node : graph_.nodes())
      if (is_object(node)) read_object(node);
    for (const GraphNode& node : graph_.nodes())
      if (node.has_type(iri::kPattern)) read_pattern(node);
    for (const GraphNode& node : graph_.nodes()) check_is_reached(node);
    for (const GraphNode& node : graph_.nodes()) check_own_properties(node);
    name_blank_nodes();
    draft_.unused = unused_parts(graph_, uses_, names_);
    return std::move(draft_);
  }

 private:
  NodeUse& use_of(const GraphNode& node) { return uses_[node.position()]; }
  const NodeUse& use_of(const GraphNode& node) const { return uses_[node.position()]; }

  /// A prefix lets any word through the context, so Opal's own words are looked up; and a word must be one that can
  /// be written again.
  static void check_words(const GraphNode& node) {
    if (node.has_type(iri::kOverlay)) node.fail("a MapOverlay, expected a map; opal map overlay lays it over one");
    for (const auto& [key, value] : node.content().items()) {
      if (is_own(key) && !is_own_term(key))
        node.fail("unknown key " + compact_name(key) + ", expected a term of " + kContextIri);
      if (key[0] != '@' && !json_ld::is_spelled_out(key)) node.fail("key " + key + expected_iri(key));
    }
    const auto is_unsayable = [](const std::string& type) { return !json_ld::is_spelled_out(type) && !is_blank(type); };
    if (const std::string* type = node.find_type(is_unsayable))
      node.fail(node.description() + " has a @type that stands for no IRI, " + *type + expected_iri(*type));
  }

  /// What a node is to the map decides which of Opal's properties it may have.
  void check_own_properties(const GraphNode& node) const {
    const NodeUse& use = use_of(node);
    if (!use.any()) return;  // kept as unused, whatever it says
    for (const auto& [key, value] : node.content().items())
      if (is_own(key) && !use.holds_property(key)) {
        const std::string expected =
            listed_by(use.properties(), [](const std::string& property) { return short_term(property); });
        node.fail(node.description() + " has " + short_term(key) + ", which means nothing there; expected " +
                  (expected.empty() ? "none of Opal's properties" : expected));
      }
  }

  void read_map_name(const GraphNode& node) {
    if (!node.has_type(iri::kSemanticMap)) return;
    if (has_map_node_) node.fail("a second SemanticMap, expected one in a document");
    has_map_node_ = true;
    if (const std::optional<std::string> name = node.text(iri::kName)) draft_.name = *name;
    if (const auto smear = node.number(iri::kSmear)) draft_.origin.smear_m = *smear;
    read_origin_notes(node, draft_.origin);
    use_of(node).add(NodeRole::map);
  }

  void read_placement(const GraphNode& node) {
    require_name(node, "which is the prefix of what it placed");
    use_of(node).add(NodeRole::placement);
    draft_.origin.placements.push_back(
        {node.id(),
         Pose2(node.required_number(iri::kX), node.required_number(iri::kY), node.required_number(iri::kHeading)),
         Point(node.required_number(iri::kScaleX), node.required_number(iri::kScaleY))});
  }

  // ------------------------------------------------------------ objects

  static bool is_object(const GraphNode& node) {
    if (node.has_type(iri::kRepresentation)) return false;
    if (node.has(iri::kRepresentedBy)) return true;
    return node.any_type(is_object_type);
  }

  /// The type that says most: Opal's before others, bot:Element and geo:Feature only if there is nothing else.
  static std::string object_type(const GraphNode& node) {
    const auto rank = [](const std::string& type) {
      return is_own(type) ? 0 : type == iri::kElement ? 2 : type == iri::kGeoFeature ? 3 : 1;
    };
    std::vector<std::string> types = node.types();
    if (types.empty()) node.fail(node.description() + " has no @type, expected one: Wall, Column, Door, ...");
    std::stable_sort(types.begin(), types.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    return types.front();
  }

  static void require_name(const GraphNode& node, const char* reason) {
    if (is_blank(node.id())) node.fail(node.description() + ", expected an @id, " + reason);
  }

  void read_object(const GraphNode& node) {
    require_name(node, "by which associations can name the object");
    const std::string type = object_type(node);
    use_of(node).add(NodeRole::object);
    use_of(node).object_type = type;
    // Of an object that nothing represents, bot:Element only says that it is one, which the typed map knows.
    if (!node.has(iri::kRepresentedBy)) use_of(node).add(NodeRole::element);
    draft_.objects.push_back({node.id(), type, {}, read_object_notes(node)});
    draft_.object_places.push_back(node.place());
    for (const GraphReference& reference : node.references(iri::kRepresentedBy)) {
      const GraphNode& representation = graph_.at(reference, node);
      if (!representation.has_type(iri::kRepresentation))
        node.fail_at(reference.place, node.description() + " is represented by a " + representation.description() +
                                          ", expected an ObjectFeatureRepresentation");
      read_representation(representation);
    }
  }

  void read_representation(const GraphNode& node) {
    if (use_of(node).plays(NodeRole::representation))
      node.fail(node.description() + " belongs to two objects, expected one");
    use_of(node).add(NodeRole::representation);
    MapFeature feature;
    feature.object = MapObjectNumber(draft_.objects.size() - 1);
    feature.representation = node.id();
    if (const auto sensor = node.reference(iri::kPerceivableBy)) feature.sensor = sensor_name(*sensor, node);
    if (const auto type = node.reference(iri::kFeatureType)) feature.type = type->id;
    read_qualities(node, feature);
    std::vector<GraphReference> geometries = node.references(iri::kRepresentedBy);
    for (GraphReference& reference : node.references(iri::kHasGeometry)) geometries.push_back(std::move(reference));
    if (geometries.empty()) node.fail(node.description() + " has no represented_by, expected a geometry");
    for (const GraphReference& reference : geometries) read_feature(graph_.at(reference, node), feature);
  }

  std::string sensor_name(const GraphReference& reference, const GraphNode& from) {
    if (is_blank(reference.id))
      from.fail_at(reference.place, "a sensor without @id, expected a name such as PlanarLidar2D");
    if (const GraphNode* node = graph_.find(reference.id)) use_of(*node).add(NodeRole::sensor);
    return reference.id;
  }

  static void read_qualities(const GraphNode& node, MapFeature& feature) {
    if (const auto sigma = node.number(iri::kPositionSigma)) feature.position_sigma_m = *sigma;
    if (const auto existence = node.number(iri::kExistence)) feature.existence = *existence;
  }

  // ------------------------------------------------------------ geometry

  void read_feature(const GraphNode& node, MapFeature feature) {
    require_name(node, "by which associations can name the feature");
    use_of(node).add(NodeRole::feature);
    feature.id = node.id();
    read_qualities(node, feature);  // what the geometry says of itself goes before what its representation says
    read_geometry(node, feature);
    features_of_geometry_[feature.id].emplace_back(draft_.features.size());
    draft_.features.push_back(std::move(feature));
    draft_.feature_places.push_back(node.place());
  }

  void read_geometry(const GraphNode& node, MapFeature& feature) {
    const bool shapes[] = {node.has_type(iri::kLineSegment), node.has_type(iri::kCorner), node.has_type(iri::kCircle),
                           node.has_type(iri::kPoint)};
    if (std::count(std::begin(shapes), std::end(shapes), true) != 1)
      node.fail(node.description() + " is a geometry, expected one of the types LineSegment, Corner, Circle, Point");
    if (shapes[0]) read_segment(node, feature);
    if (shapes[1]) read_corner(node, feature);
    if (shapes[2]) read_circle(node, feature);
    if (shapes[3]) {
      feature.geometry = point_at(node);
      feature.points = {node.id()};
    }
  }

  void read_segment(const GraphNode& node, MapFeature& feature) {
    use_of(node).add(NodeRole::segment);
    const Segment segment{point(node, iri::kBegin, feature), point(node, iri::kEnd, feature)};
    if (segment.length_m() <= kRounding_m)
      node.fail(node.description() + " begins and ends at " + position_text(segment.begin) +
                ", expected two different points");
    feature.geometry = segment;
  }

  void read_corner(const GraphNode& node, MapFeature& feature) {
    use_of(node).add(NodeRole::corner);
    feature.geometry = OrientedPoint{point(node, iri::kCornerPoint, feature), node.required_number(iri::kHeading),
                                     node.required_number(iri::kOpening)};
  }

  void read_circle(const GraphNode& node, MapFeature& feature) {
    use_of(node).add(NodeRole::circle);
    feature.geometry = Circle{point(node, iri::kCenter, feature), node.required_number(iri::kRadius)};
  }

  Point point(const GraphNode& node, std::string_view property, MapFeature& feature) {
    const GraphReference reference = node.required_reference(property);
    const GraphNode& point = graph_.at(reference, node);
    feature.points.push_back(point.id());
    if (is_blank(point.id())) {
      const std::string name = feature.id + "/" + short_term(property);
      std::string& first_name = names_.try_emplace(point.id(), name).first->second;
      first_name = std::min(first_name, name);
    }
    return point_at(point);
  }

  Point point_at(const GraphNode& node) {
    use_of(node).add(NodeRole::point);
    if (!node.has_type(iri::kPoint)) node.fail(node.description() + " is used as a point, expected @type Point");
    const Point position(node.required_number(iri::kX), node.required_number(iri::kY));
    if (position.cwiseAbs().maxCoeff() > kFarthest_m)
      node.fail(node.description() + " is at " + position_text(position) +
                ", expected metres in the map frame, at most 1e6 from its origin");
    return position;
  }

  static std::string position_text(const Point& point) { return nlohmann::json{point.x(), point.y()}.dump(); }

  // ------------------------------------------------------------ patterns

  void read_pattern(const GraphNode& node) {
    require_name(node, "by which other patterns can name it");
    use_of(node).add(NodeRole::pattern);
    MapPattern pattern{node.id(), node.required_reference(iri::kTemplate).id, {}};
    const std::optional<GraphReference> named_sensor = node.reference(iri::kPerceivableBy);
    for (const GraphReference& member : node.reference_list(iri::kFeatures))
      pattern.features.push_back(feature_number(node, member, named_sensor));
    for (const GraphReference& part : node.reference_list(iri::kSubpatterns)) pattern.subpatterns.push_back(part.id);
    pattern.dimensions = node.number_list(iri::kDimensions);
    draft_.patterns.push_back(std::move(pattern));
    draft_.pattern_places.push_back(node.place());
  }

  MapFeatureNumber feature_number(const GraphNode& pattern, const GraphReference& member,
                                  const std::optional<GraphReference>& sensor) const {
    const auto found = features_of_geometry_.find(member.id);
    if (found == features_of_geometry_.end())
      pattern.fail_at(member.place, pattern.description() + " has the member '" + member.id +
                                        "', expected a geometry that represents an object");
    if (!sensor && found->second.size() > 1)
      pattern.fail_at(member.place, "several sensors perceive '" + member.id +
                                        "', expected a perceivable_by that tells which one the pattern is for");
    for (const MapFeatureNumber number : found->second)
      if (!sensor || draft_.feature(number).sensor == sensor->id) return number;
    pattern.fail_at(member.place, "sensor '" + sensor->id + "' does not perceive '" + member.id +
                                      "', expected the pattern's members to be perceivable by its sensor");
  }

  // ------------------------------------------------------------ the rest

  /// A representation that no object has would be a part of the map that silently does not count.
  void check_is_reached(const GraphNode& node) const {
    if (node.has_type(iri::kRepresentation) && !use_of(node).plays(NodeRole::representation))
      node.fail(node.description() + " belongs to no object, expected a represented_by that refers to it");
  }

  /// Points are named after the first feature that uses them; representations only if something is said of them.
  void name_blank_nodes() {
    for (MapFeature& feature : draft_.features) {
      for (std::string& point : feature.points)
        if (is_blank(point)) point = names_.at(point);
      if (is_blank(feature.representation)) feature.representation = representation_name(feature);
    }
  }

  std::string representation_name(const MapFeature& feature) {
    const GraphNode& node = *graph_.find(feature.representation);
    if (unused_part(node, use_of(node)).is_null()) return "";
    return names_.try_emplace(feature.representation, feature.id + "/representation").first->second;
  }

  const Graph& graph_;
  MapDraft draft_;
  NodeUses uses_;
  std::unordered_map<std::string, std::string> names_;  // of blank nodes
  std::unordered_map<std::string, std::vector<MapFeatureNumber>> features_of_geometry_;
  bool has_map_node_ = false;
};

}  // namespace

MapDraft read_graph(const Graph& graph, const std::string& source, const std::string& default_name) {
  return Reader(graph, source, default_name).draft();
}

}  // namespace opal
