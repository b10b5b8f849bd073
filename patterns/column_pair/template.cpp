#include "template.hpp"

#include <tuple>

namespace opal::column_pair {
namespace {

/// One order of two members is accepted: by their difference, or where there is none at all, by place.
bool goes_first(double difference, const Point& a, const Point& b) {
  if (difference != 0) return difference > 0;  // not for NaN
  return std::tuple(a.x(), a.y()) < std::tuple(b.x(), b.y());
}

}  // namespace

PointPair::PointPair(std::array<GeometryKind, 2> kinds, const nlohmann::json& options)
    : kinds_(kinds),
      reach_m_(options.at("reach_m")),
      min_distance_m_(options.at("min_distance_m")),
      distance_tolerance_m_(options.at("distance_tolerance_m")),
      tolerance_(read_member_tolerance(options)) {}

PatternShape PointPair::shape() const { return {{kinds_[0], kinds_[1]}, reach_m_}; }

std::optional<PatternInstance> PointPair::match(std::span<const Feature* const> features) const {
  const Geometry &a = features[0]->geometry, &b = features[1]->geometry;
  const Point at_a = anchor_of(a), at_b = anchor_of(b), way = at_b - at_a;
  const double distance = way.norm();
  if (!(distance >= min_distance_m_)) return std::nullopt;  // NaN too
  const Point axis = way / distance;
  PatternInstance instance;
  instance.members = {0, 1};
  instance.invariants = {{distance, distance_tolerance_m_, Comparison::equal}};
  if (kinds_[0] == kinds_[1]) {
    const MemberRank rank = rank_members(a, axis, b, -axis, tolerance_);
    if (!goes_first(rank.difference, at_a, at_b)) return std::nullopt;
    instance.symmetric = std::abs(rank.difference) < rank.tolerance;
    append_exchangeable(a, axis, b, -axis, tolerance_, instance.invariants);
  } else {
    append_member(a, axis, tolerance_, instance.invariants);
    append_member(b, -axis, tolerance_, instance.invariants);
  }
  instance.frame = {0.5 * (at_a + at_b), std::atan2(way.y(), way.x())};
  return instance;
}

PairWithWall::PairWithWall(GeometryKind kind, const nlohmann::json& options)
    : kind_(kind),
      reach_m_(options.at("reach_m")),
      min_distance_m_(options.at("min_distance_m")),
      distance_tolerance_m_(options.at("distance_tolerance_m")),
      min_length_m_(options.at("min_length_m")),
      length_slack_m_(options.at("length_slack_m")),
      tolerance_(read_member_tolerance(options)) {}

PatternShape PairWithWall::shape() const { return {{kind_, GeometryKind::segment}, reach_m_}; }

std::optional<PatternInstance> PairWithWall::match(std::span<const Feature* const> features) const {
  const Geometry& member = features[0]->geometry;
  const auto& face = std::get<Segment>(features[1]->geometry);
  if (!(face.length_m() >= min_length_m_)) return std::nullopt;  // NaN too
  const Point along = face.direction(), from_face = anchor_of(member) - face.begin;
  const double distance = face.normal().dot(from_face);
  if (!(distance >= min_distance_m_)) return std::nullopt;  // behind the face nobody sees both
  const double foot = along.dot(from_face);
  PatternInstance instance;
  instance.members = {0, 1};
  instance.invariants = {{distance, distance_tolerance_m_, Comparison::equal},
                         {-foot, length_slack_m_, Comparison::mapped_at_most},
                         {face.length_m() - foot, length_slack_m_, Comparison::mapped_at_least}};
  append_member(member, along, tolerance_, instance.invariants);
  instance.frame = {face.begin + foot * along, face.heading_rad()};
  return instance;
}

}  // namespace opal::column_pair
