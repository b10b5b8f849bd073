#include "map/overlay/map_overlay.hpp"

#include "map/overlay/overlay_draft.hpp"

#include <algorithm>
#include <iterator>

namespace opal {
namespace {

using nlohmann::json;

/// Features of one representation have one sensor; where a change has made that untrue, they part.
void part_representations(std::vector<MapFeature>& features) {
  std::map<std::string, std::set<std::string>> sensors;
  for (const MapFeature& feature : features) sensors[feature.representation].insert(feature.sensor);
  for (MapFeature& feature : features)
    if (sensors[feature.representation].size() > 1) feature.representation.clear();
}

void sort_by_id(std::vector<std::string>& sentences) {
  const auto id_of = [](const std::string& sentence) { return sentence.substr(0, sentence.find(": ")); };
  std::sort(sentences.begin(), sentences.end(), [&](const std::string& a, const std::string& b) {
    const std::string id_a = id_of(a), id_b = id_of(b);
    return id_a == id_b ? a < b : id_before(id_a, id_b);
  });
}

}  // namespace

OverlaidMap overlaid_map(const SemanticMap& map, const std::vector<MapOverlay>& overlays,
                         const OverlayOptions& options) {
  OverlaidMap result;
  OverlayDraft draft(map);
  json statements = json::array();
  std::map<std::string, std::string> prefixes;
  for (const MapOverlay& overlay : overlays) {
    const json said = add_to(draft, overlay, result.changes);
    statements.insert(statements.end(), said.begin(), said.end());
    prefixes.insert(overlay.prefixes.begin(), overlay.prefixes.end());
  }
  const std::vector<MapFeature> before = draft.features;
  ChangeMaker changes(draft, options);
  changes.make(overlays);
  std::move(changes.sentences.begin(), changes.sentences.end(), std::back_inserter(result.changes));
  result.doubts = std::move(changes.doubts);
  turn_corners(before, changes.set_corners, draft, result.changes, result.doubts);
  const std::vector<MapFeatureNumber> numbers = draft.settle();
  std::vector<MapPattern> patterns = adapted_patterns(map, draft.features, numbers, result.changes);
  part_representations(draft.features);
  result.map =
      map.with_contents(std::move(draft.objects), std::move(draft.features), std::move(patterns), prefixes, statements);
  sort_by_id(result.changes);
  sort_by_id(result.doubts);
  return result;
}

}  // namespace opal
