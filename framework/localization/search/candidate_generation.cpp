#include "localization/search/candidate_generation.hpp"

#include "patterns/mapped_patterns.hpp"

#include "localization/alignment/registration.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace opal {
namespace {

// More features per geometry double the patterns and hardly add a rarer one.
constexpr int kFeaturesPerGeometry = 8;
// Along a pattern's free direction: half of what alignment recovers from.
constexpr double kSweepStep_m = 0.2;

bool is_under_constrained(const PatternInstance& instance) { return instance.extent_max_m > instance.extent_min_m; }

/// How much of a building a feature fixes; orders features of one kind.
double weight_of(const Feature& feature) {
  if (const auto* segment = std::get_if<Segment>(&feature.geometry))
    return feature.support_m > 0 ? feature.support_m : segment->length_m();
  return -anchor_of(feature.geometry).norm();  // nearer points are known better
}

/// The `most` best features of each geometry.
std::vector<SearchFeature> best_per_geometry(std::span<const SearchFeature> features, int most) {
  std::vector<SearchFeature> sorted(features.begin(), features.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const SearchFeature& a, const SearchFeature& b) {
    return weight_of(a.feature) > weight_of(b.feature);
  });
  std::array<int, 4> taken{};
  std::vector<SearchFeature> best;
  for (SearchFeature& each : sorted)
    if (taken[each.feature.geometry.index()]++ < most) best.push_back(std::move(each));
  return best;
}

double support_of(const PatternInstance& observed, std::span<const Feature> features) {
  double least = std::numeric_limits<double>::infinity();
  for (int member : observed.members) least = std::min(least, weight_of(features[member]));
  return least;
}

}  // namespace

CandidateGenerator::CandidateGenerator(std::shared_ptr<const MapView> map,
                                       std::vector<Named<PatternTemplate>> templates, const SearchOptions& options)
    : map_(std::move(map)), options_(options) {
  MappedPatterns mapped = mapped_patterns(*map_, templates);
  mapped_ = std::move(mapped.features);
  for (std::size_t k = 0; k < templates.size(); ++k)
    tables_.push_back({templates[k].name, templates[k].part, std::move(mapped.by_template[k])});
}

/// Observed patterns of one template that the map knows: well supported ones; of those, the ones that the index expects
/// least often.
std::vector<CandidateGenerator::Lookup> CandidateGenerator::shortlist(TemplateNumber pattern,
                                                                      std::span<const Feature> features,
                                                                      bool under_constrained) const {
  const auto& [name, part, index] = table(pattern);
  std::vector<Lookup> lookups;
  for (PatternInstance& observed : find_patterns(*part, features))
    if (is_under_constrained(observed) == under_constrained) lookups.push_back({pattern, std::move(observed), 0});
  std::stable_sort(lookups.begin(), lookups.end(), [&](const Lookup& a, const Lookup& b) {
    return support_of(a.observed, features) > support_of(b.observed, features);
  });
  const auto most =
      static_cast<std::size_t>(under_constrained ? options_.under_constrained_patterns : options_.patterns);
  if (lookups.size() > most) lookups.erase(lookups.begin() + static_cast<std::ptrdiff_t>(most), lookups.end());
  const auto limit = static_cast<std::size_t>(options_.lookup_limit);
  for (Lookup& lookup : lookups) lookup.expected = index.count(lookup.observed, limit);
  std::erase_if(lookups, [](const Lookup& lookup) { return lookup.expected == 0; });
  keep_rarest(lookups, limit, 1, under_constrained);
  return lookups;
}

void CandidateGenerator::keep_rarest(std::vector<Lookup>& lookups, std::size_t most_places, std::size_t fewest,
                                     bool under_constrained) {
  constexpr std::size_t kPlacesPerSweep = 3;
  std::stable_sort(lookups.begin(), lookups.end(),
                   [](const Lookup& a, const Lookup& b) { return a.expected < b.expected; });
  std::size_t places = 0, kept = 0;
  for (const Lookup& lookup : lookups) {
    places += lookup.expected * (under_constrained ? kPlacesPerSweep : 1);
    if (kept >= fewest && places > most_places) break;
    ++kept;
  }
  lookups.erase(lookups.begin() + static_cast<std::ptrdiff_t>(kept), lookups.end());
}

std::vector<CandidateGenerator::Lookup> CandidateGenerator::choose(std::span<const SearchFeature> best,
                                                                   bool under_constrained) const {
  constexpr std::size_t kFewest = 3;
  std::vector<Feature> features;
  for (const SearchFeature& each : best) features.push_back(each.feature);
  std::vector<Lookup> chosen;
  for (std::size_t k = 0; k < tables_.size(); ++k)
    for (Lookup& lookup : shortlist(TemplateNumber(k), features, under_constrained))
      chosen.push_back(std::move(lookup));
  if (options_.places > 0) keep_rarest(chosen, static_cast<std::size_t>(options_.places), kFewest, under_constrained);
  leave_out_parts(chosen);
  return chosen;
}

/// A pattern that contains others says all that they say, and fewer places look like it: its parts are not looked up
/// (Algorithm 3, Hendrikx 2023).
void CandidateGenerator::leave_out_parts(std::vector<Lookup>& chosen) {
  const auto is_part = [](const std::vector<int>& part, const std::vector<int>& whole) {
    return part.size() < whole.size() && std::all_of(part.begin(), part.end(), [&](int member) {
             return std::find(whole.begin(), whole.end(), member) != whole.end();
           });
  };
  std::vector<std::vector<int>> wholes;
  for (const Lookup& lookup : chosen) wholes.push_back(lookup.observed.members);
  std::erase_if(chosen, [&](const Lookup& lookup) {
    return std::any_of(wholes.begin(), wholes.end(),
                       [&](const auto& whole) { return is_part(lookup.observed.members, whole); });
  });
}

bool CandidateGenerator::nearer(const Place& a, const Place& b) { return a.likelihood_field > b.likelihood_field; }

void CandidateGenerator::keep_nearest(std::vector<Place>& places, std::size_t most) {
  if (places.size() <= most) return;
  std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(most), places.end(), nearer);
  places.resize(most);
}

void CandidateGenerator::sweep(const PatternInstance& observed, const PatternTable& table, int mapped,
                               const Point& position, std::vector<Point>& positions) const {
  if (!is_under_constrained(observed)) {
    positions.push_back(position);
    return;
  }
  const auto [begins_m, ends_m] = table.extent_m(mapped);
  const double from = begins_m - observed.extent_min_m - observed.overhang_m;
  const double to = ends_m - observed.extent_max_m + observed.overhang_m;
  const Point along = unit_vector(table.frame(mapped).heading_rad());
  for (double u = std::min(from + kSweepStep_m, (from + to) / 2); u <= to + 1e-9; u += 3 * kSweepStep_m)
    positions.push_back(position + u * along);
}

bool CandidateGenerator::is_in_region(const Point& position) const {
  return !options_.region || (position - options_.region->center).norm() <= options_.region->radius_m;
}

void CandidateGenerator::look_up(const Lookup& lookup, int number, const TellingPoints& points, BestShare& filter,
                                 std::vector<Place>& places) const {
  const PatternIndex& index = table(lookup).index;
  struct Way {
    Pose2 T_frame_base;  ///< how the observed frame may lie on the mapped one
    TellingPoints::First
        points;  ///< in axes of the mapped frame: a sine per mapped pattern would cost as much as the rest
  };
  const Pose2 T_frame_base = lookup.observed.frame.inverse(),
              turned_about = Pose2(0, 0, std::numbers::pi) * T_frame_base;
  std::vector<Way> ways{{T_frame_base, turned(points.first(), T_frame_base)}};
  if (lookup.observed.symmetric) ways.push_back({turned_about, turned(points.first(), turned_about)});
  std::vector<Point> positions;
  constexpr std::size_t kAhead = 16;
  const std::vector<int> found = index.find(lookup.observed);
  for (std::size_t f = 0; f < found.size(); ++f) {
    const int k = found[f];
    const Pose2& frame = index.patterns().frame(k);
    if (f + kAhead < found.size()) index.patterns().prefetch(found[f + kAhead]);
    for (const Way& way : ways) {
      const double heading_rad = wrap_angle(frame.heading_rad() + way.T_frame_base.heading_rad());
      const TellingPoints::First on_map = turned(way.points, frame);
      positions.clear();
      sweep(lookup.observed, index.patterns(), k, frame * way.T_frame_base.position(), positions);
      for (const Point& position : positions) {
        if (!is_in_region(position)) continue;
        const float likelihood_field = coarse_likelihood_field(on_map, *map_, position, filter.bar());
        if (filter.passes(likelihood_field)) places.push_back({position, heading_rad, likelihood_field, number, k});
      }
    }
  }
}

void CandidateGenerator::look_closely(std::vector<Place>& places, std::vector<TellingPoints>& points,
                                      double slack_m) const {
  for (Place& place : places) {
    points[place.lookup].turn_to(place.heading_rad);
    place.likelihood_field = points[place.lookup].likelihood_field(*map_, place.position, slack_m);
  }
}

std::vector<CandidateGenerator::Place> CandidateGenerator::with_neighbours(const std::vector<Place>& places,
                                                                           const std::vector<Lookup>& lookups) const {
  std::vector<Place> all;
  for (const Place& place : places) {
    const Pose2& frame = table(lookups[place.lookup]).index.patterns().frame(place.mapped);
    const Point step = kSweepStep_m * unit_vector(frame.heading_rad());
    for (int steps = -1; steps <= 1; ++steps) {
      all.push_back(place);
      all.back().position += steps * step;
    }
  }
  return all;
}

std::vector<CandidateGenerator::Place> CandidateGenerator::places_for(const std::vector<Lookup>& lookups,
                                                                      std::span<const Point> coarse,
                                                                      bool under_constrained) const {
  constexpr std::size_t kSweepsLookedAt = 3000;
  const auto close_looks = static_cast<std::size_t>(options_.close_looks);
  std::vector<TellingPoints> points;
  std::vector<Place> places;
  BestShare filter(close_looks, 30);
  for (std::size_t k = 0; k < lookups.size(); ++k) {
    points.emplace_back(lookups[k].observed, coarse);
    if (points.back().enough()) look_up(lookups[k], static_cast<int>(k), points.back(), filter, places);
  }
  keep_nearest(places, under_constrained ? kSweepsLookedAt : close_looks);
  look_closely(places, points, under_constrained ? kSweepStep_m / 2 : 0);
  if (!under_constrained) return places;
  keep_nearest(places, close_looks);
  places = with_neighbours(places, lookups);
  look_closely(places, points, 0);
  return places;
}

std::vector<Association> CandidateGenerator::pair_up(const Lookup& lookup, int mapped, const Pose2& T_map_base,
                                                     std::span<const SearchFeature> features) const {
  const std::span<const int> members = table(lookup).index.patterns().members(mapped);
  std::vector<Association> pairs;
  for (std::size_t slot = 0; slot < lookup.observed.members.size(); ++slot) {
    const SearchFeature& observed = features[lookup.observed.members[slot]];
    const std::vector<MapFeatureNumber>& numbers = mapped_[members[slot]].numbers;
    const Point place = T_map_base * anchor_of(observed.feature.geometry);
    const auto nearer_one = [&](MapFeatureNumber a, MapFeatureNumber b) {
      return distance_m(map_->feature(a).geometry, place) < distance_m(map_->feature(b).geometry, place);
    };
    pairs.push_back({observed.local, *std::min_element(numbers.begin(), numbers.end(), nearer_one)});
  }
  return pairs;
}

CandidateGenerator::Proposal CandidateGenerator::propose(std::span<const SearchFeature> features,
                                                         std::span<const Point> coarse, bool under_constrained) const {
  Proposal proposal;
  const std::vector<SearchFeature> best = best_per_geometry(features, kFeaturesPerGeometry);
  const std::vector<Lookup> lookups = choose(best, under_constrained);
  for (const Lookup& lookup : lookups) {
    proposal.looked_up.push_back({lookup.pattern, {}, lookup.expected});
    for (int member : lookup.observed.members) proposal.looked_up.back().local_features.push_back(best[member].local);
  }
  std::vector<Place> places = places_for(lookups, coarse, under_constrained);
  std::stable_sort(places.begin(), places.end(), nearer);
  std::vector<Pose2> poses;
  for (const Place& place : places) poses.emplace_back(place.position, place.heading_rad);
  for (std::size_t k : distinct_places(poses, 0.35, 0.12, options_.candidates)) {
    const Place& place = places[k];
    const Lookup& lookup = lookups[place.lookup];
    proposal.candidates.push_back({poses[k], lookup.pattern, pair_up(lookup, place.mapped, poses[k], best)});
  }
  return proposal;
}

std::vector<std::size_t> distinct_places(std::span<const Pose2> poses, double distance, double angle,
                                         std::size_t most) {
  std::unordered_map<std::int64_t, std::vector<std::size_t>> kept_by_cell;
  const auto cell = [&](double v) { return static_cast<std::int64_t>(std::floor(v / distance)); };
  const auto key = [](std::int64_t i, std::int64_t j) { return i * 73856093 ^ j * 19349663; };
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < poses.size() && kept.size() < most; ++k) {
    const std::int64_t i = cell(poses[k].x()), j = cell(poses[k].y());
    bool taken = false;
    for (std::int64_t a = i - 1; a <= i + 1 && !taken; ++a)
      for (std::int64_t b = j - 1; b <= j + 1 && !taken; ++b) {
        const auto it = kept_by_cell.find(key(a, b));
        if (it == kept_by_cell.end()) continue;
        for (std::size_t other : it->second)
          taken = taken ||
                  (distance_m(poses[other], poses[k]) < distance && angle_between_rad(poses[other], poses[k]) < angle);
      }
    if (taken) continue;
    kept_by_cell[key(i, j)].push_back(k);
    kept.push_back(k);
  }
  return kept;
}

}  // namespace opal
