#pragma once

#include <opal/local_map/local_map.hpp>
#include <opal/localization/observation/observation.hpp>
#include <opal/localization/scoring/hypothesis.hpp>
#include <opal/map/view/map_view.hpp>

#include <string>
#include <vector>

namespace opal::testing {

/// A robot that has driven a little, and what it then sees: the truth to judge hypotheses against.
class Visit {
 public:
  /// @param T_map_base  where the robot stands at last.
  Visit(const MapView& view, const Pose2& T_map_base);

  const Hypothesis& truth() const { return truth_; }
  /// A quarter of the beams, and every feature. It refers to this visit.
  Observation observation() const;

 private:
  void see_features(const MapView& view, const Pose2& T_map_base);
  void associate(const Pose2& T_map_base);

  LocalMap local_map_;
  Scan scan_;
  std::vector<Feature> features_;
  std::vector<MapFeatureNumber> numbers_;
  Hypothesis truth_;
};

struct NamedHypothesis {
  std::string name;
  Hypothesis hypothesis;
};

/// The truth and what differs from it.
std::vector<NamedHypothesis> hypotheses_near(const Hypothesis& truth);

}  // namespace opal::testing
