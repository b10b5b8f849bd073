#include "scorer.hpp"

#include <cmath>

NewObjectsScorer::NewObjectsScorer(const nlohmann::json& options)
    : new_nat_(options.at("new_nat")),
      known_nat_(options.at("known_nat")),
      astray_nat_(options.at("astray_nat")),
      sigma_m_(options.at("sigma_m")),
      enough_scans_(options.at("enough_scans")),
      forget_(options.at("forget")) {}

// A hypothesis that has met nothing yet: every object is new to it.
std::unique_ptr<opal::ScorerMemory> NewObjectsScorer::new_memory(const opal::MapView&) const {
  return std::make_unique<SeenObjects>();
}

// Reads the memory and leaves it as it is. What the scan adds is returned, and the framework decides whether it counts.
opal::Score NewObjectsScorer::score(const opal::Hypothesis& hypothesis, const opal::Observation& observation,
                                    const opal::MapView& map, const opal::ScorerMemory* memory) const {
  if (observation.points() == 0) return {};
  const auto& before = static_cast<const SeenObjects&>(*memory);  // new_memory made it
  auto now = std::make_shared<SeenObjects>(seen_now(hypothesis, observation, map));
  double seen_nat = 0, seen = 0;
  for (const auto& [object, scans] : now->scans) {
    seen_nat += scans * worth_nat(object, before);
    seen += scans;
  }
  const double astray_nat = astray_nat_ * (1 - seen);
  return {seen_nat - astray_nat, {}, {{"seen", seen_nat}, {"astray", -astray_nat}}, std::move(now)};
}

// A weight of nearly 0 is a robot that stands: it learns nothing new, however many scans it takes.
void NewObjectsScorer::remember(opal::ScorerMemory& memory, const opal::ScorerMemory& seen, double weight) const {
  auto& all = static_cast<SeenObjects&>(memory).scans;
  for (const auto& [object, scans] : static_cast<const SeenObjects&>(seen).scans) all[object] += weight * scans;
}

// What was seen long ago becomes new again, and is dropped when nearly nothing is left: the memory stays small.
void NewObjectsScorer::fade(opal::ScorerMemory& memory, double weight) const {
  auto& all = static_cast<SeenObjects&>(memory).scans;
  for (auto& [object, scans] : all) scans *= 1 - weight * forget_;
  std::erase_if(all, [](const auto& entry) { return entry.second < 1e-3; });
}

SeenObjects NewObjectsScorer::seen_now(const opal::Hypothesis& hypothesis, const opal::Observation& observation,
                                       const opal::MapView& map) const {
  const opal::Pose2 T_map_base = observation.T_map_base(hypothesis.T_map_local);
  const double share = 1.0 / static_cast<double>(observation.points());
  SeenObjects now;
  for (const opal::ObservedScan& scan : observation.scans) {  // one a laser
    const opal::Point eye = T_map_base * scan.laser_position;
    for (const opal::Point& point : scan.points) {
      const opal::Point end = T_map_base * point;
      const opal::MapFeatureNumber face = map.nearest_facing(end, end - eye);
      if (!face.exists()) continue;
      const double off = map.surface(face).distance_m(end) / sigma_m_;
      now.scans[map.surface(face).object] += share * std::exp(-0.5 * off * off);
    }
  }
  return now;
}

double NewObjectsScorer::worth_nat(opal::MapObjectNumber object, const SeenObjects& before) const {
  const auto at = before.scans.find(object);
  const double newness = at == before.scans.end() ? 1 : 1 / (1 + at->second / enough_scans_);
  return known_nat_ + newness * (new_nat_ - known_nat_);
}
