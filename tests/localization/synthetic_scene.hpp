#pragma once

#include "localization/observation/observation.hpp"
#include "localization/observation/plugin_failures.hpp"
#include "localization/scoring/scorer_ensemble.hpp"

#include <opal/local_map/local_map.hpp>
#include <opal/localization/options/localizer_options.hpp>
#include <opal/localization/scoring/hypothesis_scorer.hpp>
#include <opal/map/view/map_view.hpp>
#include <opal/patterns/pattern_template.hpp>
#include <opal/sensing/sample.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

// A small world in which the right decision is known, for tests of decisions.

namespace opal::synthetic {

using Features = std::vector<Feature>;

/// A room of 10 m by 7 m about (5, 3.5): walls, corners, and a column off its middle, so that no turn of it looks the
/// same.
Features room();
Features moved(const Pose2& motion, const Features& features);
/// A wall as a detector has it that sees all of it.
Feature seen_wall(const Point& begin, const Point& end);
/// A map of these, in this order; a feature's number is its position. Perceived by "lidar".
std::shared_ptr<const MapView> view_of(const Features& features);

/// The laser sits ahead of base_link, so that a mix-up of the two frames shows.
inline const Pose2 T_base_laser{0.2, 0, 0};
/// What a perfect laser that sees all around sees of a map; sensor frame.
Scan scan_from(const MapView& map, const Pose2& T_map_base);
/// The corners and columns of a map as a perfect detector has them; sensor frame.
Features detected_from(const MapView& map, const Pose2& T_map_base);

/// A robot in a map whose dead reckoning is perfect, and what it observes at each pose.
class Robot {
 public:
  Robot(std::shared_ptr<const MapView> map, const Pose2& T_map_base);
  void drive_to(const Pose2& T_map_base);
  /// Sees nothing at all.
  void drive_blind_to(const Pose2& T_map_base);

  const LocalMap& local_map() const { return local_map_; }
  const Scan& scan() const { return scan_; }
  Sample sample() const;
  /// What detectors found; base_link frame.
  SeenFeatures seen() const;
  Observation observation() const;
  const Pose2& T_map_base() const { return T_map_base_; }
  /// The hypothesis that is right, or one by which the robot is elsewhere now.
  Hypothesis truth() const { return at(T_map_base_); }
  Hypothesis at(const Pose2& T_map_base) const;

 private:
  void add(const Pose2& T_map_base, Scan scan, const Features& features);

  std::shared_ptr<const MapView> map_;
  LocalMap local_map_;
  Scan scan_;
  Features features_;
  Pose2 T_map_base_;
};

/// Says what it is told to.
struct ToldScorer : HypothesisScorer {
  using Say = std::function<Score(const Hypothesis&, const Observation&)>;
  explicit ToldScorer(Say what) : say(std::move(what)) {}
  Score score(const Hypothesis& hypothesis, const Observation& observation, const MapView&,
              const ScorerMemory*) const override {
    return say(hypothesis, observation);
  }
  Say say;
};

/// The sum of the weights of all that it has seen of a hypothesis. It speaks up for what it has seen little of.
struct CountMemory : ScorerMemory {
  double count = 0;
  std::unique_ptr<ScorerMemory> copy() const override { return std::make_unique<CountMemory>(*this); }
};
struct CountingScorer : HypothesisScorer {
  std::unique_ptr<ScorerMemory> new_memory(const MapView&) const override { return std::make_unique<CountMemory>(); }
  /// As its log-likelihood, what it has seen so far.
  Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory* memory) const override;
  void remember(ScorerMemory& memory, const ScorerMemory& seen, double weight) const override;
  void fade(ScorerMemory& memory, double weight) const override;
};
/// What the scorer at this position has seen of a hypothesis.
double count_of(const Hypothesis& hypothesis, std::size_t scorer);

/// How well the points lie on the map: 3 nat where all do, -3 nat where none does.
std::shared_ptr<const HypothesisScorer> fit_scorer();
std::shared_ptr<const HypothesisScorer> constant_scorer(double nat, const std::string& veto = {});

/// An ensemble with what it needs to live.
struct Judges {
  Judges(std::shared_ptr<const MapView> map, std::vector<ActiveScorer> scorers)
      : ensemble(std::move(scorers), std::move(map), failures) {}
  PluginFailures failures;
  ScorerEnsemble ensemble;
};

/// Verification of candidates by the newest scan alone.
VerificationOptions no_earlier_scans();
/// Stable or not.
std::vector<const LocalFeature*> all_features_of(const LocalMap& local_map);

/// A corner, whose direction fixes the pose.
struct CornerTemplate : PatternTemplate {
  PatternShape shape() const override { return {{GeometryKind::oriented_point}, 0}; }
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override;
};
/// A piece of a wall, which may be anywhere along a mapped one.
struct WallTemplate : PatternTemplate {
  PatternShape shape() const override { return {{GeometryKind::segment}, 0}; }
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override;
};

}  // namespace opal::synthetic
