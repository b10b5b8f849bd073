// What overlays add to a map.
#include "map/document/semantic_map_reader.hpp"
#include "map/map_vocabulary.hpp"
#include "map/overlay/overlay_draft.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <array>

namespace opal {
namespace {

using nlohmann::json;
using namespace vocabulary;

constexpr std::array kPointWords{iri::kBegin, iri::kEnd, iri::kCornerPoint, iri::kCenter};

std::set<std::string> defined_ids(const json& nodes) {
  std::set<std::string> ids;
  for (const json& node : nodes) ids.insert(node["@id"].get<std::string>());
  return ids;
}

json point_node(const std::string& id, const Point& position) {
  const auto value = [](double number) { return json::array({json{{"@value", number}}}); };
  return {{"@id", id},
          {"@type", json::array({std::string(iri::kPoint)})},
          {std::string(iri::kX), value(position.x())},
          {std::string(iri::kY), value(position.y())}};
}

/// The overlay's nodes, and the points of the map that they use.
json with_points_of_map(const OverlayDraft& draft, const MapOverlay& overlay) {
  json nodes = overlay.additions;
  std::set<std::string> known = defined_ids(nodes);
  for (const json& node : overlay.additions)
    for (const std::string_view word : kPointWords)
      for (const json& reference : node.value(std::string(word), json::array())) {
        const std::string id = reference.value("@id", "");
        const auto found = draft.features_by_point.find(compact_name(id, overlay.prefixes));
        if (found == draft.features_by_point.end() || !known.insert(id).second) continue;
        const OverlayDraft::Place& place = found->second.front();
        nodes.push_back(point_node(id, points_of(draft.feature(place.feature).geometry)[place.point]));
      }
  return nodes;
}

MapDraft read_additions(const OverlayDraft& draft, const MapOverlay& overlay) {
  const Graph graph(with_points_of_map(draft, overlay), overlay.source);
  MapDraft read = read_graph(graph, overlay.source, "");
  read.prefixes = overlay.prefixes;
  check_references(read);
  name_everything(read);
  check_ids(read);
  check_values(read);
  return read;
}

/// What was there before the overlay, for this sensor or, as a change may have disabled it, for none.
MapFeatureNumber number_of_twin(const OverlayDraft& draft, const MapFeature& feature, std::size_t known) {
  const auto same_id = draft.features_by_id.find(feature.id);
  if (same_id == draft.features_by_id.end()) return {};
  for (const std::string& sensor : {feature.sensor, std::string()})
    for (const MapFeatureNumber i : same_id->second)
      if (i < MapFeatureNumber(known) && !draft.is_twin(i) && draft.feature(i).sensor == sensor) return i;
  return {};
}

void check_unused(const MapOverlay& overlay, const json& unused) {
  for (const json& node : unused)
    if (is_blank(node["@id"].get<std::string>()))
      throw MapError(overlay.source + ": " + node.dump().substr(0, 80) +
                     ": a node without @id, expected one; it means nothing to Opal");
}

}  // namespace

json add_to(OverlayDraft& draft, const MapOverlay& overlay, std::vector<std::string>& added) {
  if (overlay.additions.empty()) return json::array();
  MapDraft read = read_additions(draft, overlay);
  check_unused(overlay, read.unused);
  const std::size_t known_features = draft.features.size();
  std::vector<MapObjectNumber> numbers;
  for (std::size_t i = 0; i < read.objects.size(); ++i) {
    MapObject& object = read.objects[i];
    const auto known = draft.objects_by_id.find(object.id);
    const bool is_new = known == draft.objects_by_id.end();
    if (is_new) added.push_back(object.id + ": added, " + object.type);
    if (!is_new) draft.object_twins.push_back({object, overlay.source + ": " + read.object_places[i]});
    numbers.push_back(is_new ? draft.add(object) : known->second);
  }
  for (std::size_t i = 0; i < read.features.size(); ++i) {
    MapFeature& feature = read.features[i];
    feature.object = numbers[feature.object.number()];
    const MapFeatureNumber original = number_of_twin(draft, feature, known_features);
    const bool of_map = original.exists();
    if (!of_map) added.push_back(feature.id + ": added to '" + draft.object(feature.object).id + "', " + feature.type);
    const MapFeatureNumber number = draft.add(std::move(feature));
    if (of_map) draft.feature_twins[number] = {original, overlay.source + ": " + read.feature_places[i]};
  }
  return read.unused;
}

}  // namespace opal
