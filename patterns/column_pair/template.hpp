#pragma once

#include <opal/patterns/pattern_member.hpp>
#include <opal/patterns/pattern_template.hpp>

#include <array>

namespace opal::column_pair {

/// Two features that have a place, columns or corners: the column_pair pattern of Hendrikx (2023), 4.3.1. Dimensions:
/// their distance, then what each member says of itself (opal/patterns/pattern_member.hpp). Members of one kind are
/// ordered by these numbers; where they hardly differ, the pattern is symmetric.
class PointPair final : public PatternTemplate {
 public:
  PointPair(std::array<GeometryKind, 2> kinds, const nlohmann::json& options);
  PatternShape shape() const override;
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override;

 private:
  std::array<GeometryKind, 2> kinds_;
  double reach_m_, min_distance_m_, distance_tolerance_m_;
  MemberTolerance tolerance_;
};

/// A feature that has a place, and a face that it does not lie on. The face gives the direction, the feature the place
/// along it. Dimensions: the distance from the face's line; where the face begins and ends, seen from the feature's
/// foot (an observed face may be a part of the mapped one); what the feature says of itself.
class PairWithWall final : public PatternTemplate {
 public:
  PairWithWall(GeometryKind kind, const nlohmann::json& options);
  PatternShape shape() const override;
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override;

 private:
  GeometryKind kind_;
  double reach_m_, min_distance_m_, distance_tolerance_m_, min_length_m_, length_slack_m_;
  MemberTolerance tolerance_;
};

}  // namespace opal::column_pair
