#include <opal/plugin/testing/scorer_contract.hpp>

#include "plugin/testing/scene.hpp"
#include "plugin/testing/scorer_memory_laws.hpp"
#include "plugin/testing/violations.hpp"
#include "plugin/testing/visit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace opal::testing {
namespace {

MapFeature map_feature(const std::string& type, int number, const Geometry& geometry) {
  MapFeature feature;
  feature.id = type + "-" + std::to_string(number) + "-feature";
  feature.object = MapObjectNumber(number);
  feature.type = "opal:" + type;
  feature.sensor = "PlanarLidar2D";
  feature.geometry = geometry;
  return feature;
}

std::shared_ptr<const SemanticMap> moved(const SemanticMap& map, const Pose2& motion) {
  std::vector<MapFeature> features = map.features();
  for (MapFeature& feature : features) feature.geometry = transformed(motion, feature.geometry);
  return SemanticMap::make(map.name(), map.objects(), std::move(features), map.patterns());
}

class Judging {
 public:
  Judging(const HypothesisScorer& scorer, const TypeInfo& type, const ScorerTrial& trial)
      : scorer_(scorer), trial_(trial), violations_(type.name) {}

  std::vector<std::string> run() {
    const auto map = trial_.map ? trial_.map : example_map();
    const MapView view(map, trial_.sensor);
    for (const Pose2& place : places(view)) {
      const Visit visit(view, place);
      for (const auto& [name, hypothesis] : hypotheses_near(visit.truth())) {
        check(name, hypothesis, visit.observation(), view);
        check_poor(name, hypothesis, visit.observation(), view);
      }
      check_together(visit, view);
      for (const Pose2& motion : {Pose2(3.25, -7.5, 0), Pose2(-11.3, 4.7, 0.83)}) check_moved(visit, view, motion);
    }
    return violations_.take();
  }

 private:
  std::vector<Pose2> places(const MapView& view) const {
    if (!trial_.T_map_base.empty()) return trial_.T_map_base;
    if (trial_.map == nullptr) return {{3, 4, 0.3}, {10, 2.5, 2.6}, {7.6, 4.1, -1.2}};
    const auto [low, high] = view.bounds();
    return {{0.5 * (low + high), 0.3}};
  }

  std::optional<Score> ask(const std::string& name, const Hypothesis& hypothesis, const Observation& seen,
                           const MapView& view) {
    std::optional<Score> score;
    violations_.expect_no_throw(name, [&] { score = scorer_.score_new(hypothesis, seen, view); });
    return score;
  }

  void check(const std::string& name, const Hypothesis& hypothesis, const Observation& seen, const MapView& view) {
    const auto score = ask(name, hypothesis, seen, view);
    if (!score) return;
    if (!std::isfinite(score->log_likelihood))  // what follows compares numbers
      return violations_.add("finite", "gives " + name + " a score of " + std::to_string(score->log_likelihood));
    for (const Score::Term& term : score->breakdown) {
      if (term.name.empty()) violations_.add("name", "gives " + name + " a score with a term without a name");
      if (!std::isfinite(term.value))
        violations_.add("term",
                        "gives " + name + " a score whose term " + term.name + " is " + std::to_string(term.value));
    }
    const auto again = ask(name, hypothesis, seen, view);
    if (!(again && same_score(*again, *score)))
      violations_.add("repeat", "gives " + name + " another score when it is asked again",
                      "a member that score() changes; what must be remembered belongs into a ScorerMemory");
    check_findings(name, hypothesis, seen, view);
    check_memory({scorer_, name, hypothesis, seen, view}, violations_);
    if (!scorer_.judges_associations()) check_without_associations(name, *score, hypothesis, seen, view);
  }

  /// Last bits may differ: who judges many at once may add up in another order.
  void check_together(const Visit& visit, const MapView& view) {
    const std::vector<NamedHypothesis> named = hypotheses_near(visit.truth());
    const Observation seen = visit.observation();
    std::vector<const Hypothesis*> all;
    for (const NamedHypothesis& each : named) all.push_back(&each.hypothesis);
    std::vector<Score> scores;
    violations_.expect_no_throw("all hypotheses together", [&] {
      const auto memory = scorer_.new_memory(view);
      scores = scorer_.score_all(all, std::vector<const ScorerMemory*>(all.size(), memory.get()), seen, view);
      for (std::size_t k = 0; k < all.size(); ++k) {
        const double alone = scorer_.score(*all[k], seen, view, memory.get()).log_likelihood;
        if (scores.size() == all.size() && std::isfinite(alone) &&
            !(std::abs(scores[k].log_likelihood - alone) <= 1e-9 * (1 + std::abs(alone))))
          violations_.add("together", "gives " + named[k].name + " another score when it judges many in one call");
      }
      if (scores.size() != all.size())
        violations_.add("together", "gives " + std::to_string(scores.size()) + " scores for " +
                                        std::to_string(all.size()) + " hypotheses in one call");
    });
  }

  void check_without_associations(const std::string& name, const Score& score, Hypothesis hypothesis,
                                  const Observation& seen, const MapView& view) {
    hypothesis.associations.clear();
    const auto alone = ask(name, hypothesis, seen, view);
    if (alone && !same_score(*alone, score))
      violations_.add(
          "associations",
          "gives " + name + " another score than without its associations, which it says it does not judge");
  }

  void check_findings(const std::string& name, const Hypothesis& hypothesis, const Observation& seen,
                      const MapView& view) {
    std::vector<Finding> findings;
    violations_.expect_no_throw("explaining " + name, [&] { findings = scorer_.explain(hypothesis, seen, view); });
    for (const Finding& finding : findings) {
      if (finding.words.empty()) violations_.add("finding", "explains " + name + " with a finding without words");
      if (finding.map_feature >= MapFeatureNumber(view.map().features().size()))
        violations_.add("finding", "explains " + name + " with a mapped feature that does not exist");
      const bool finite = std::ranges::all_of(finding.line, [](const Point& p) { return p.allFinite(); });
      if (!finite || (finding.line.size() != 0 && finding.line.size() != 2))
        violations_.add("finding", "explains " + name + " with a line that is not two finite points");
    }
  }

  void check_poor(const std::string& name, const Hypothesis& hypothesis, const Observation& seen, const MapView& view) {
    const LocalMap nothing(LocalMapOptions{}, nullptr);
    check(name + " of an empty observation", hypothesis, Observation{nothing, {}}, view);
    Observation dark = seen;
    ObservedScan& scan = dark.scans.front();
    const ObservedScan full = std::exchange(scan, {.laser_position = scan.laser_position,
                                                   .free_bearings_rad = scan.free_bearings_rad,
                                                   .range_max_m = scan.range_max_m});
    dark.features.clear();
    dark.feature_scans.clear();
    check(name + " of a scan without returns", hypothesis, dark, view);
    scan.free_bearings_rad.clear();
    if (!full.points.empty()) {
      scan.points = {full.points.front()};
      scan.beams = {full.beams.front()};
      scan.evidence_cells = {full.evidence_cells.front()};
    }
    check(name + " of a scan with one return", hypothesis, dark, view);
    check(name + " of two lasers", hypothesis, seen_by_two(seen), view);
  }

  /// What a second laser at the robot's back sees of the same surfaces.
  static Observation seen_by_two(Observation seen) {
    ObservedScan second = seen.scans.front();
    second.laser_position = Point(-0.2, 0);
    seen.scans.push_back(std::move(second));
    for (std::size_t k = 0; k < seen.features.size(); ++k) seen.feature_scans[k] = static_cast<int>(k % 2);
    return seen;
  }

  void check_moved(const Visit& visit, const MapView& view, const Pose2& motion) {
    const MapView moved_view(moved(view.map(), motion), trial_.sensor);
    for (const auto& [name, hypothesis] : hypotheses_near(visit.truth())) {
      if (name.find("outside") != std::string::npos) continue;
      Hypothesis image = hypothesis;
      image.T_map_local = motion * hypothesis.T_map_local;
      const auto here = ask(name, hypothesis, visit.observation(), view);
      const auto there = ask(name, image, visit.observation(), moved_view);
      if (!here || !there || !std::isfinite(here->log_likelihood) || !std::isfinite(there->log_likelihood)) continue;
      if (!(std::abs(here->log_likelihood - there->log_likelihood) <= trial_.rigid_tolerance_nat))
        violations_.add("rigid",
                        "gives " + name + " " + std::to_string(here->log_likelihood) + " nat, but " +
                            std::to_string(there->log_likelihood) +
                            " nat after map and hypothesis were moved together" +
                            fmt::format(", expected the same within {:g} nat", trial_.rigid_tolerance_nat),
                        "coordinates of the map frame count by themselves: a grid at its origin, or its axes");
      if (here->veto.empty() != there->veto.empty())
        violations_.add("veto", "vetoes " + name + " or not, depending on where the map's origin is");
    }
  }

  const HypothesisScorer& scorer_;
  const ScorerTrial& trial_;
  Violations violations_;
};

}  // namespace

std::shared_ptr<const SemanticMap> example_map() {
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  const auto add = [&](const std::string& type, const Geometry& geometry) {
    const int number = static_cast<int>(objects.size());
    objects.push_back({type + "-" + std::to_string(number), "opal:" + type});
    features.push_back(map_feature(type, number, geometry));
  };
  // Two rooms, 7.2 m and 6.6 m wide, with a doorway in a wall 0.2 m thick between them.
  for (const Geometry& face : room({{0, 0},
                                    {7.2, 0},
                                    {7.2, 3.5},
                                    {7.4, 3.5},
                                    {7.4, 0},
                                    {14, 0},
                                    {14, 6.8},
                                    {7.4, 7.6},
                                    {7.4, 4.6},
                                    {7.2, 4.6},
                                    {7.2, 8},
                                    {0, 8}}))
    add("Wall", face);
  for (const Point& center : {Point(2, 2), Point(5, 6.5), Point(11, 4.5)}) add("Column", Circle{center, 0.25});
  add("Corner", OrientedPoint{{0, 0}, 0.25 * std::numbers::pi, 0.5 * std::numbers::pi});
  return SemanticMap::make("example", std::move(objects), std::move(features));
}

std::vector<std::string> scorer_violations(const HypothesisScorer& scorer, const TypeInfo& type,
                                           const ScorerTrial& trial) {
  return Judging(scorer, type, trial).run();
}

}  // namespace opal::testing
