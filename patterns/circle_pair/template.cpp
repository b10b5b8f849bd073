#include "template.hpp"

#include <tuple>

CirclePair::CirclePair(const nlohmann::json& options)
    : reach_m_(options.at("reach_m")),
      distance_tolerance_m_(options.at("distance_tolerance_m")),
      radius_tolerance_m_(options.at("radius_tolerance_m")) {}

opal::PatternShape CirclePair::shape() const {
  return {{opal::GeometryKind::circle, opal::GeometryKind::circle}, reach_m_};
}

std::optional<opal::PatternInstance> CirclePair::match(std::span<const opal::Feature* const> features) const {
  const auto& a = std::get<opal::Circle>(features[0]->geometry);
  const auto& b = std::get<opal::Circle>(features[1]->geometry);
  const auto rank = [](const opal::Circle& c) { return std::tuple(-c.radius_m, c.center.x(), c.center.y()); };
  if (rank(b) < rank(a)) return std::nullopt;
  const opal::Point way = b.center - a.center;
  if (way.norm() < 1e-6) return std::nullopt;
  opal::PatternInstance instance;
  instance.members = {0, 1};
  instance.invariants = {{way.norm(), distance_tolerance_m_, opal::Comparison::equal},
                         {a.radius_m, radius_tolerance_m_, opal::Comparison::equal},
                         {b.radius_m, radius_tolerance_m_, opal::Comparison::equal}};
  instance.frame = {0.5 * (a.center + b.center), std::atan2(way.y(), way.x())};
  instance.symmetric = std::abs(a.radius_m - b.radius_m) < 2 * radius_tolerance_m_;
  return instance;
}
