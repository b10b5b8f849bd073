#include "viewer/scene/frame_scene.hpp"

#include "report/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal {
namespace {

/// The map as far as it is drawn. Ids are new: the recording's are not needed for that, and may clash
/// where one geometry stands once per sensor.
std::shared_ptr<const SemanticMap> drawn_map(const RunHeader& header) {
  std::vector<MapObject> objects;
  for (const auto& object : header.objects) objects.push_back({fmt::format("o{}", objects.size()), object.type});
  std::vector<MapFeature> features;
  for (const auto& recorded : header.features) {
    MapFeature feature;
    feature.id = fmt::format("f{}", features.size());
    feature.object = recorded.object;
    feature.type = recorded.type;
    feature.geometry = recorded.geometry;
    features.push_back(std::move(feature));
  }
  return SemanticMap::make(header.map_name, std::move(objects), std::move(features));
}

/// Adds what is known in the robot's or the local frame, as the best hypothesis places it.
class PlacedByBest {
 public:
  PlacedByBest(const RunHeader& header, const RunState& state, DrawingScene& scene)
      : header_(header),
        state_(state),
        best_(*state.best()),
        scene_(scene),
        T_map_local_(best_.T_map_base * state.frame().T_local_base.inverse()) {}

  void add_scan() {
    for (const Point& p : state_.frame().scan) scene_.scan_points.push_back(best_.T_map_base * p);
    for (const Point& p : state_.frame().free_space) scene_.free_space.push_back(best_.T_map_base * p);
  }

  void add_local_features() {
    for (const auto& [id, feature] : state_.local_features())
      scene_.local_features.push_back({transformed(T_map_local_, feature.geometry), perception_of(feature)});
  }

  void add_associations() {
    for (const Association& pair : best_.pairs) {
      const RecordedLocalFeature* local = find(pair.local_feature);
      if (!local || !pair.map_feature.exists()) continue;
      scene_.associations.push_back(
          {transformed(T_map_local_, local->geometry), header_.feature(pair.map_feature).geometry});
    }
  }

  void add_patterns() {
    if (!state_.frame().search) return;
    for (const auto& lookup : state_.frame().search->patterns) {
      std::vector<Point> members;
      for (const LocalFeatureId id : lookup.local_features)
        if (const RecordedLocalFeature* local = find(id)) members.push_back(T_map_local_ * anchor_of(local->geometry));
      if (members.size() > 1) scene_.patterns.push_back(std::move(members));
    }
  }

  void add_contradictions() {
    for (const RecordedFinding& finding : state_.frame().findings)
      if (finding.line.size() == 2) scene_.contradictions.push_back({finding.line[0], finding.line[1]});
  }

 private:
  const RecordedLocalFeature* find(LocalFeatureId id) const {
    const auto found = state_.local_features().find(id);
    return found == state_.local_features().end() ? nullptr : &found->second;
  }
  DrawingScene::Perception perception_of(const RecordedLocalFeature& feature) const {
    const bool matched = std::any_of(best_.pairs.begin(), best_.pairs.end(), [&](const Association& pair) {
      return pair.local_feature == feature.id && pair.map_feature.exists();
    });
    if (matched) return DrawingScene::Perception::matched;
    return feature.stable ? DrawingScene::Perception::stable : DrawingScene::Perception::candidate;
  }

  const RunHeader& header_;
  const RunState& state_;
  const TracedHypothesis& best_;
  DrawingScene& scene_;
  const Pose2 T_map_local_;
};

/// Those that ended just now, and those that had to be reckoned with once. A place that another hypothesis
/// took over did not fall.
void add_ended(const RunState& state, DrawingScene& scene) {
  constexpr double kReckonedWith = 0.05;
  for (const EndedHypothesis& ended : state.ended()) {
    const bool shown = ended.end_keyframe == state.frame().keyframe || ended.life.highest_probability >= kReckonedWith;
    if (shown && !ended.end.merged_into.exists()) scene.ended.push_back(ended.end.T_map_base);
  }
}

void add_hypotheses(const RunState& state, DrawingScene& scene) {
  for (const RecordedHypothesis& row : state.frame().hypotheses)
    scene.hypotheses.push_back({row.T_map_base, row.probability});
  // The scene's first is the best; the estimate's best is the recorder's word for it.
  if (const TracedHypothesis* best = state.best()) {
    const auto& rows = state.frame().hypotheses;
    const auto place = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.id == best->id; });
    std::rotate(scene.hypotheses.begin(), scene.hypotheses.begin() + (place - rows.begin()),
                scene.hypotheses.begin() + (place - rows.begin()) + 1);
  }
}

/// The end of a name that is too long for a title.
std::string shortened(const std::string& name) {
  constexpr std::size_t kLongest = 60;
  if (name.size() <= kLongest) return name;
  std::size_t begin = name.size() - kLongest;
  while (begin < name.size() && (static_cast<unsigned char>(name[begin]) & 0xC0) == 0x80) ++begin;
  return "..." + name.substr(begin);
}

std::string title_of(const RunHeader& header, const RunState& state) {
  const RunFrame& frame = state.frame();
  const std::string log = header.log.substr(header.log.find_last_of('/') + 1);
  return (log.empty() ? "" : shortened(log) + ", ") + shortened(state.time_line()) + " at " +
         fixed_text(frame.time_s, 2) + " s: " + frame.status + ", probability " + probability_text(frame.probability);
}

}  // namespace

DrawingScene scene_of(const RunHeader& header, const RunState& state, const std::vector<std::string>& notes) {
  DrawingScene scene;
  scene.title = title_of(header, state);
  scene.notes = notes;
  scene.map = drawn_map(header);
  scene.trajectory = state.trajectory();
  scene.truth = state.truth();
  add_hypotheses(state, scene);
  add_ended(state, scene);
  if (!state.best()) return scene;
  PlacedByBest placed(header, state, scene);
  placed.add_scan();
  placed.add_local_features();
  placed.add_associations();
  placed.add_patterns();
  placed.add_contradictions();
  return scene;
}

}  // namespace opal
