#include "scorer.hpp"

#include <fmt/format.h>
#include <opal/map/object_words.hpp>

#include <algorithm>
#include <functional>
#include <sstream>

namespace opal::score_free_space {
namespace {

/// What the outlines are made of, in the order in which it was given.
std::vector<double> numbers_of(const Observation& observation, double margin_m) {
  std::vector<double> numbers{margin_m};
  for (const ObservedScan& seen : observation.scans) {
    numbers.insert(numbers.end(), {seen.range_max_m, seen.laser_position.x(), seen.laser_position.y()});
    for (const Point& p : seen.points) numbers.insert(numbers.end(), {p.x(), p.y()});
    numbers.insert(numbers.end(), seen.free_bearings_rad.begin(), seen.free_bearings_rad.end());
  }
  return numbers;
}

std::vector<Point> outline_of(const ObservedScan& seen, const FreeSpaceOptions& options) {
  Scan scan;
  scan.range_max_m = seen.range_max_m;
  scan.free_bearings_rad = seen.free_bearings_rad;
  for (const Point& point : seen.points) {
    const Point ray = point - seen.laser_position;
    scan.points.push_back({ray, ray.norm(), std::atan2(ray.y(), ray.x()), 0});
  }
  return free_space_outline(scan, Pose2(seen.laser_position, 0), options);
}

}  // namespace

struct FreeSpaceScorer::Memory {
  std::vector<double> numbers;
  std::vector<ScanRoom> rooms;
};

FreeSpaceScorer::FreeSpaceScorer(const nlohmann::json& options)
    : outline_{options.at("reach_m"), options.at("gap_rad"), options.at("tolerance_m")},
      margin_m_(options.at("margin_m")),
      sigmas_(options.at("sigmas")),
      unmatched_m_(options.at("unmatched_m")),
      weight_nat_per_m_(options.at("weight_nat_per_m")),
      most_m_(options.at("most_m")),
      veto_m_(options.at("veto_m")),
      memory_(std::make_unique<Memory>()) {
  std::istringstream names(options.at("no_evidence").get<std::string>());
  for (std::string name; names >> name;) no_evidence_.insert(name);
}

FreeSpaceScorer::~FreeSpaceScorer() = default;

double FreeSpaceScorer::margin_for(const Observation& observation) const {
  const ScanMatch& match = observation.local_map.last_match();
  if (!match.converged) return margin_m_ + unmatched_m_;
  const double sideways = std::sqrt(std::max({0.0, match.covariance(0, 0), match.covariance(1, 1)}));
  const double turned = outline_.reach_m / 2 * std::sqrt(std::max(0.0, match.covariance(2, 2)));
  return margin_m_ + std::min(sigmas_ * std::hypot(sideways, turned), outline_.reach_m / 4);
}

const std::vector<FreeSpaceScorer::ScanRoom>& FreeSpaceScorer::rooms_of(const Observation& observation) const {
  const double margin_m = margin_for(observation);
  std::vector<double> numbers = numbers_of(observation, margin_m);
  if (numbers != memory_->numbers) {
    memory_->rooms.clear();
    for (const ObservedScan& scan : observation.scans)
      memory_->rooms.push_back({FreeRoom(outline_of(scan, outline_), margin_m), scan.laser_position});
    memory_->numbers = std::move(numbers);
  }
  return memory_->rooms;
}

FreeSpaceScorer::Overlap FreeSpaceScorer::overlap_of(const FreeRoom& room, const Pose2& T_base_map, const Point& eye,
                                                     MapFeatureNumber number, const MapView& map) const {
  const MapFeature& feature = map.feature(number);
  Overlap overlap{number, 0, {}};
  if (no_evidence_.contains(map.map().object(feature.object).type)) return overlap;
  Segment body;
  if (const auto* face = std::get_if<Segment>(&feature.geometry)) {
    body = transformed(T_base_map, *face);
  } else if (const auto* column = std::get_if<Circle>(&feature.geometry)) {
    const Point center = T_base_map * column->center, view = center - eye;
    if (view.norm() == 0) return overlap;
    const Point side = column->radius_m * left_of(view.normalized());
    body = {center - side, center + side};
  } else {
    return overlap;  // points and corners have no extent: their faces tell
  }
  for (const Segment& part : room.inside(body, sigmas_ * feature.position_sigma_m)) {
    overlap.length_m += feature.existence * part.length_m();
    if (part.length_m() > overlap.longest.length_m()) overlap.longest = part;
  }
  return overlap;
}

std::vector<FreeSpaceScorer::Overlap> FreeSpaceScorer::overlaps(const Pose2& T_map_base, const ScanRoom& seen,
                                                                const MapView& map) const {
  const Pose2 T_base_map = T_map_base.inverse();
  std::vector<MapFeatureNumber> near = map.within(T_map_base * seen.laser_position, outline_.reach_m);
  std::ranges::sort(near);  // sums do not depend on the order of an index
  std::vector<Overlap> found;
  for (const MapFeatureNumber number : near) {
    const Overlap overlap = overlap_of(seen.room, T_base_map, seen.laser_position, number, map);
    if (overlap.length_m > 0) found.push_back(overlap);
  }
  return found;
}

/// Where several lasers look, a mapped feature counts by what most of it stands in.
std::vector<FreeSpaceScorer::Overlap> FreeSpaceScorer::overlaps(const Pose2& T_map_base, const Observation& observation,
                                                                const MapView& map) const {
  std::vector<Overlap> most;
  for (const ScanRoom& seen : rooms_of(observation))
    for (const Overlap& overlap : overlaps(T_map_base, seen, map)) {
      const auto known =
          std::ranges::find_if(most, [&](const Overlap& other) { return other.map_feature == overlap.map_feature; });
      if (known == most.end())
        most.push_back(overlap);
      else if (overlap.length_m > known->length_m)
        *known = overlap;
    }
  return most;
}

Score FreeSpaceScorer::score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
                             const ScorerMemory*) const {
  const Pose2 T_map_base = observation.T_map_base(hypothesis.T_map_local);
  double overlap_m = 0;
  for (const Overlap& overlap : overlaps(T_map_base, observation, map)) overlap_m += overlap.length_m;
  Score score{-weight_nat_per_m_ * std::min(overlap_m, most_m_), {}, {{"overlap_m", overlap_m}}};
  if (veto_m_ > 0 && overlap_m > veto_m_)
    score.veto = fmt::format("{:.2f} m of mapped geometry stand in free space, more than {:.2f} m", overlap_m, veto_m_);
  return score;
}

std::vector<Finding> FreeSpaceScorer::explain(const Hypothesis& hypothesis, const Observation& observation,
                                              const MapView& map) const {
  const Pose2 T_map_base = observation.T_map_base(hypothesis.T_map_local);
  std::vector<Overlap> found = overlaps(T_map_base, observation, map);
  std::ranges::stable_sort(found, std::greater{}, &Overlap::length_m);
  std::vector<Finding> findings;
  for (const Overlap& overlap : found) {
    findings.push_back({fmt::format("{:.2f} m of {} stand where the scan shows free space", overlap.length_m,
                                    object_words(map.map(), map.feature(overlap.map_feature).object)),
                        overlap.map_feature,
                        {T_map_base * overlap.longest.begin, T_map_base * overlap.longest.end}});
  }
  return findings;
}

}  // namespace opal::score_free_space
