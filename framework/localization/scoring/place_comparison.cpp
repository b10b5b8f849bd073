#include "localization/scoring/place_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace opal {
namespace {

// Of a scan: a few dozen beams on what differs are enough, and each costs a walk through the map per place.
constexpr std::size_t kBeams = 100;
// A surface this far behind a beam's end still says where the beam should have ended.
constexpr double kLookAhead_m = 1;
// Expected ranges that differ by less are errors of map and pose.
constexpr double kApart_m = 0.3;
// A beam ends on a surface up to here, and a little more per metre.
constexpr double kOn_m = 0.15, kOnPerMetre = 0.01;
// Places are compared up to this share of beams that tell them apart.
constexpr double kMostTelling = 0.15;
// Outcomes at a right place before anything is seen, and the beams of a hundred that this weighs.
constexpr std::array<double, 3> kUsual{0.05, 0.25, 0.7};
constexpr double kUsualWeight = 5;
// Neighbouring evidence cells see one thing, and errors of the map are common to them.
constexpr double kShare = 0.25;

double sum_of(std::span<const double> outcomes) { return std::accumulate(outcomes.begin(), outcomes.end(), 0.0); }

}  // namespace

double PlaceComparison::Pair::nat() const {
  const double alike = sum_of(common);
  Outcomes log_likelihood{};
  for (std::size_t o = 0; o < kUsual.size(); ++o)
    log_likelihood[o] = std::log((common[o] + kUsualWeight * kUsual[o]) / (alike + kUsualWeight));
  double nat = 0, different = 0;
  for (const auto& [cell, seen] : telling) {
    double lead = 0;
    for (std::size_t o = 0; o < kUsual.size(); ++o) lead += (seen.first[o] - seen.second[o]) * log_likelihood[o];
    const double beams = sum_of(seen.first);
    nat += lead / (beams + 1);
    different += beams;
  }
  return different > kMostTelling * (different + alike) ? 0 : kShare * nat;
}

void PlaceComparison::Pair::fade(double kept) {
  for (double& beams : common) beams *= kept;
  for (auto& [cell, seen] : telling) {
    for (double& beams : seen.first) beams *= kept;
    for (double& beams : seen.second) beams *= kept;
  }
}

auto PlaceComparison::pair_of(HypothesisId first, HypothesisId second) -> Pair& {
  const auto found = std::find_if(pairs_.begin(), pairs_.end(),
                                  [&](const Pair& pair) { return pair.first == first && pair.second == second; });
  return found != pairs_.end() ? *found : pairs_.emplace_back(Pair{.first = first, .second = second});
}

void PlaceComparison::forget_all_but(std::span<const Place> places) {
  const auto is_there = [&](HypothesisId id) {
    return std::any_of(places.begin(), places.end(), [&](const Place& place) { return place.hypothesis == id; });
  };
  std::erase_if(pairs_, [&](const Pair& pair) { return !is_there(pair.first) || !is_there(pair.second); });
}

auto PlaceComparison::expect(const Point& eye, const Point& end) const -> Expected {
  const double range = (end - eye).norm();
  const Point beyond = end + kLookAhead_m / range * (end - eye);
  const MapView::Crossing met = map_->first_crossing(eye, beyond, 0);
  if (!met.feature.exists()) return {range + kLookAhead_m, Outcome::ends_before};
  const double behind = range - met.range_m;
  if (behind > kApart_m) return {met.range_m, Outcome::passes};
  const bool is_on = std::abs(behind) < kOn_m + kOnPerMetre * met.range_m;
  return {met.range_m, is_on ? Outcome::ends_on : Outcome::ends_before};
}

void PlaceComparison::add_beam(std::span<const Place> places, std::span<const Expected> expected, EvidenceCell cell,
                               double beams) {
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = a + 1; b < places.size(); ++b) {
      const auto [i, j] = places[a].hypothesis < places[b].hypothesis ? std::pair(a, b) : std::pair(b, a);
      const auto first = static_cast<std::size_t>(expected[i].outcome),
                 second = static_cast<std::size_t>(expected[j].outcome);
      Pair& pair = pair_of(places[i].hypothesis, places[j].hypothesis);
      if (std::abs(expected[i].range_m - expected[j].range_m) < kApart_m) {
        pair.common[first] += beams / 2;
        pair.common[second] += beams / 2;
        continue;
      }
      Telling& seen = pair.telling[cell];
      seen.first[first] += beams;
      seen.second[second] += beams;
    }
}

void PlaceComparison::add_scan(const ObservedScan& scan, std::span<const Place> places, double weight) {
  const std::size_t step = std::max<std::size_t>(1, scan.points.size() / kBeams),
                    looked_at = (scan.points.size() + step - 1) / step;
  std::vector<Expected> expected(places.size());
  for (std::size_t k = 0; k < scan.points.size(); k += step) {
    if (scan.points[k] == scan.laser_position) continue;
    for (std::size_t p = 0; p < places.size(); ++p)
      expected[p] = expect(places[p].T_map_base * scan.laser_position, places[p].T_map_base * scan.points[k]);
    add_beam(places, expected, scan.evidence_cells[k], weight * 100 / static_cast<double>(looked_at));
  }
}

void PlaceComparison::add(const Observation& observation, std::span<const Place> places, double weight, double memory) {
  forget_all_but(places);
  for (Pair& pair : pairs_) pair.fade(1 - weight * (1 - memory));
  const auto compared = places.first(std::min(places.size(), static_cast<std::size_t>(std::max(0, most_places_))));
  if (compared.size() < 2) return;
  for (const ObservedScan& scan : observation.scans)
    add_scan(scan, compared, weight / static_cast<double>(observation.scans.size()));
}

double PlaceComparison::against_nat(HypothesisId hypothesis) const {
  double most = 0;
  for (const Pair& pair : pairs_) {
    if (pair.first != hypothesis && pair.second != hypothesis) continue;
    const double lead = pair.nat();
    most = std::max(most, pair.first == hypothesis ? -lead : lead);
  }
  return most;
}

}  // namespace opal
