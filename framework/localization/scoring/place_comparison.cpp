#include "localization/scoring/place_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace opal {
namespace {

// At least so many of a scan, if it has them: a few dozen on what differs are enough, and each costs a walk through the
// map per place.
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

auto PlaceComparison::find(HypothesisId one, HypothesisId other) -> Pair* {
  const HypothesisId first = std::min(one, other), second = std::max(one, other);
  const auto found = std::find_if(pairs_.begin(), pairs_.end(),
                                  [&](const Pair& pair) { return pair.first == first && pair.second == second; });
  return found == pairs_.end() ? nullptr : &*found;
}

auto PlaceComparison::pair_of(HypothesisId one, HypothesisId other) -> Pair& {
  if (Pair* known = find(one, other)) return *known;
  return pairs_.emplace_back(Pair{.first = std::min(one, other), .second = std::max(one, other)});
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

void PlaceComparison::Pair::add(const Expected& at_first, const Expected& at_second, EvidenceCell cell, double beams) {
  const auto first_outcome = static_cast<std::size_t>(at_first.outcome),
             second_outcome = static_cast<std::size_t>(at_second.outcome);
  if (std::abs(at_first.range_m - at_second.range_m) < kApart_m) {
    common[first_outcome] += beams / 2;
    common[second_outcome] += beams / 2;
    return;
  }
  Telling& seen = telling[cell];
  seen.first[first_outcome] += beams;
  seen.second[second_outcome] += beams;
}

void PlaceComparison::add_scan(const ObservedScan& scan, std::span<const Place> places, double weight) {
  const std::size_t step = std::max<std::size_t>(1, scan.points.size() / kBeams),
                    looked_at = (scan.points.size() + step - 1) / step;
  const double beams = weight * 100 / static_cast<double>(looked_at);
  std::vector<EvidenceCell> cells;
  std::vector<std::vector<Expected>> expected(places.size());  // by place and beam
  for (std::size_t k = 0; k < scan.points.size(); k += step) {
    if (scan.points[k] == scan.laser_position) continue;
    cells.push_back(scan.evidence_cells[k]);
    for (std::size_t p = 0; p < places.size(); ++p)
      expected[p].push_back(expect(places[p].T_map_base * scan.laser_position, places[p].T_map_base * scan.points[k]));
  }
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = a + 1; b < places.size(); ++b) {
      const auto [i, j] = places[a].hypothesis < places[b].hypothesis ? std::pair(a, b) : std::pair(b, a);
      Pair& pair = pair_of(places[i].hypothesis, places[j].hypothesis);
      for (std::size_t k = 0; k < cells.size(); ++k) pair.add(expected[i][k], expected[j][k], cells[k], beams);
    }
}

void PlaceComparison::add_scans(const Sight& seen, std::span<const Place> places) {
  for (const ObservedScan& scan : seen.scans)
    add_scan(scan, places, seen.weight / static_cast<double>(seen.scans.size()));
}

auto PlaceComparison::best_of(std::span<const Place> places) const -> std::span<const Place> {
  return places.first(std::min(places.size(), most_places_));
}

void PlaceComparison::add(const Sight& seen) {
  forget_all_but(seen.places);
  for (Pair& pair : pairs_) pair.fade(kept_share(seen.weight, memory_));
  const std::span<const Place> compared = best_of(seen.places);
  if (compared.size() > 1) add_scans(seen, compared);
  for (Pair& pair : pairs_) pair.lead_nat = pair.nat();
}

void PlaceComparison::look_back(std::span<const Sight> before, std::span<const Place> places) {
  forget_all_but(places);
  const std::span<const Place> compared = best_of(places);
  for (std::size_t a = 0; a < compared.size(); ++a)
    for (std::size_t b = a + 1; b < compared.size(); ++b)
      if (!find(compared[a].hypothesis, compared[b].hypothesis))
        look_back(before, compared[a].hypothesis, compared[b].hypothesis);
}

void PlaceComparison::look_back(std::span<const Sight> before, HypothesisId one, HypothesisId other) {
  const auto is_compared = [&](const Place& place) { return place.hypothesis == one || place.hypothesis == other; };
  for (const Sight& seen : before) {
    std::vector<Place> both;
    std::ranges::copy_if(seen.places, std::back_inserter(both), is_compared);
    if (both.size() < 2) continue;
    pair_of(one, other).fade(kept_share(seen.weight, memory_));
    add_scans(seen, both);
  }
  Pair& pair = pair_of(one, other);
  pair.lead_nat = pair.nat();
}

double PlaceComparison::against_nat(HypothesisId hypothesis) const {
  double most = 0;
  for (const Pair& pair : pairs_) {
    if (pair.first != hypothesis && pair.second != hypothesis) continue;
    most = std::max(most, pair.first == hypothesis ? -pair.lead_nat : pair.lead_nat);
  }
  return most;
}

}  // namespace opal
