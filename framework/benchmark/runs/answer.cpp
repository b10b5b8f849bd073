#include "benchmark/runs/answer.hpp"

#include "localization/alignment/registration.hpp"
#include "report/status_text.hpp"

#include <opal/map/object_words.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace opal::benchmark {
namespace {

const opal::LocalFeature* find_local(const opal::LocalMap& map, opal::LocalFeatureId id) {
  const auto it = std::ranges::find_if(map.features(), [&](const opal::LocalFeature& f) { return f.id == id; });
  return it == map.features().end() ? nullptr : &*it;
}

std::vector<std::string> words_of(const std::vector<opal::SensorFinding>& findings) {
  std::vector<std::string> words;
  for (const opal::SensorFinding& finding : findings) words.push_back(finding.words);
  return words;
}

}  // namespace

std::vector<NamedAssociation> associations_of(const opal::Localizer& localizer) {
  std::vector<NamedAssociation> named;
  const std::vector<opal::Hypothesis> alive = localizer.hypotheses();
  if (alive.empty()) return named;
  const opal::Hypothesis& best = alive.front();
  const opal::SemanticMap& map = localizer.map().map();
  for (const opal::Association& pair : best.associations) {
    const opal::LocalFeature* local = find_local(localizer.local_map(), pair.local_feature);
    if (!local || !pair.map_feature.exists()) continue;
    const opal::MapFeature& mapped = map.feature(pair.map_feature);
    const opal::Geometry placed = transformed(best.T_map_local, local->feature.geometry);
    named.push_back({pair.local_feature, opal::object_words(map, mapped.object), mapped.id, placed, mapped.geometry,
                     mismatch(placed, mapped.geometry).position_m});
  }
  return named;
}

std::string pose_words(const opal::Pose2& pose) {
  return fmt::format("x {:.2f} m, y {:.2f} m, heading {:.1f} deg", pose.x(), pose.y(),
                     opal::degrees(pose.heading_rad()));
}

std::string place_words(const opal::Localizer& localizer, const opal::Pose2& T_map_base) {
  const opal::SemanticMap& map = localizer.map().map();
  const opal::PlaceInBuilding place = place_in_building(map, T_map_base);
  if (place.storey.empty()) return pose_words(T_map_base);
  return fmt::format("{}: {} (map: {})", words_for(map, place), pose_words(place.T_storey_base),
                     pose_words(T_map_base));
}

std::string skipped_text(const std::map<std::string, int>& plugin_failures) {
  std::string text;
  for (const auto& [plugin, count] : plugin_failures)
    text += fmt::format("skipped: {} failed {} times\n", plugin, count);
  return text;
}

void print_answer(const opal::Localizer& localizer, const opal::PoseEstimate& answer, const std::string& why) {
  const double probability = answer.has_pose ? answer.probability : 0;
  fmt::print("at the end: {}", opal::status_text(name_of(answer.status), probability));
  if (answer.has_pose) {
    fmt::print(", probability {:.3f}, {} {}\n", answer.probability, answer.hypotheses,
               answer.hypotheses == 1 ? "hypothesis" : "hypotheses");
    fmt::print("pose: {}\n", place_words(localizer, answer.T_map_base));
  } else {
    fmt::print("\nno pose\n");
  }
  if (const std::string reason = opal::reason_text(name_of(answer.status), why, words_of(localizer.sensor_findings()));
      !reason.empty())
    fmt::print("{}\n", reason);
  for (const auto& alternative : answer.alternatives)
    fmt::print("alternative:  {}, probability {:.3f}\n", place_words(localizer, alternative.T_map_base),
               alternative.probability);
  const auto associations = associations_of(localizer);
  if (!associations.empty()) fmt::print("it rests on:\n");
  for (const NamedAssociation& named : associations)
    fmt::print("  {} ({:.2f} m off): local feature {} is {}\n", named.object, named.off_m, named.local_feature.number(),
               named.feature);
  fmt::print("{}", skipped_text(localizer.plugin_failures()));
}

}  // namespace opal::benchmark
