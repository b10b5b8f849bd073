#include "localization/search/candidate_generation.hpp"

#include "localization/alignment/registration.hpp"

#include <algorithm>
#include <unordered_map>

namespace opal {
namespace {

// More features per geometry double the patterns and hardly add a rarer one.
constexpr int kFeaturesPerGeometry = 8;
// Along a pattern's free direction: half of what alignment recovers from.
constexpr double kSweepStep_m = 0.2;
// Candidates nearer than this are one: alignment recovers from 0.4 m, and so finds either from the other.
constexpr PoseTolerance kProposedApart{0.35, 0.12};

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

}  // namespace

CandidateGenerator::CandidateGenerator(std::shared_ptr<const MapView> map,
                                       std::vector<Named<PatternTemplate>> templates, const SearchOptions& options)
    : map_(std::move(map)), options_(options) {
  MappedPatterns mapped = mapped_patterns(*map_, templates);
  members_ = std::move(mapped.members);
  for (std::size_t k = 0; k < templates.size(); ++k)
    templates_.push_back({templates[k].name, templates[k].part, std::move(mapped.by_template[k])});
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
  const Point along = unit_vector(table.heading_rad(mapped));
  for (double u = std::min(from + kSweepStep_m, (from + to) / 2); u <= to + 1e-9; u += 3 * kSweepStep_m)
    positions.push_back(position + u * along);
}

bool CandidateGenerator::Inquiry::is_empty() const {
  return std::none_of(points.begin(), points.end(), [](const TellingPoints& of_lookup) { return of_lookup.enough(); });
}

std::size_t CandidateGenerator::look_up_newest(Inquiry& inquiry, std::size_t most) const {
  const PatternLookup& lookup = inquiry.lookups[inquiry.lookup];
  const PatternTable& mapped = index_of(lookup).patterns();
  struct Way {
    Pose2 T_frame_base;  ///< how the observed frame may lie on the mapped one
    TellingPoints::First
        points;  ///< in axes of the mapped frame: a sine per mapped pattern would cost as much as the rest
  };
  const TellingPoints::First points = inquiry.points[inquiry.lookup].first();
  const Pose2 T_frame_base = lookup.observed.frame.inverse(),
              turned_about = Pose2(0, 0, std::numbers::pi) * T_frame_base;
  std::vector<Way> ways{{T_frame_base, turned(points, T_frame_base)}};
  if (lookup.observed.symmetric) ways.push_back({turned_about, turned(points, turned_about)});
  std::vector<Point> positions;
  std::size_t looked_at = 0;
  constexpr std::size_t kAhead = 16;
  for (; inquiry.next < inquiry.found.size() && looked_at < most; ++inquiry.next) {
    const int k = inquiry.found[inquiry.next];
    const Pose2 frame = mapped.frame(k);
    if (inquiry.next + kAhead < inquiry.found.size()) mapped.prefetch(inquiry.found[inquiry.next + kAhead]);
    for (const Way& way : ways) {
      const double heading_rad = wrap_angle(frame.heading_rad() + way.T_frame_base.heading_rad());
      const TellingPoints::First on_map = turned(way.points, frame);
      positions.clear();
      sweep(lookup.observed, mapped, k, frame * way.T_frame_base.position(), positions);
      looked_at += positions.size();
      for (const Point& position : positions) {
        if (!options_.may_be_at(position)) continue;
        const float likelihood_field = coarse_likelihood_field(on_map, *map_, position, inquiry.filter.bar());
        if (inquiry.filter.passes(likelihood_field))
          inquiry.places.push_back({position, heading_rad, likelihood_field, static_cast<int>(inquiry.lookup), k});
      }
    }
  }
  return looked_at;
}

bool CandidateGenerator::look_up(Inquiry& inquiry, std::size_t most) const {
  for (std::size_t looked_at = 0; inquiry.lookup < inquiry.lookups.size(); ++inquiry.lookup, inquiry.next = 0) {
    if (!inquiry.points[inquiry.lookup].enough()) continue;
    const PatternLookup& lookup = inquiry.lookups[inquiry.lookup];
    if (inquiry.next == 0) inquiry.found = index_of(lookup).find(lookup.observed);
    looked_at += look_up_newest(inquiry, most - looked_at);
    if (looked_at >= most) return false;
  }
  return true;
}

void CandidateGenerator::look_closely(std::vector<Place>& places, Inquiry& inquiry, double slack_m) const {
  for (Place& place : places) {
    TellingPoints& points = inquiry.points[place.lookup];
    points.turn_to(place.heading_rad);
    place.likelihood_field = points.likelihood_field(*map_, place.position, slack_m);
  }
}

std::vector<CandidateGenerator::Place> CandidateGenerator::with_neighbours(const std::vector<Place>& places,
                                                                           const Inquiry& inquiry) const {
  std::vector<Place> all;
  for (const Place& place : places) {
    const Pose2 frame = index_of(inquiry.lookups[place.lookup]).patterns().frame(place.mapped);
    const Point step = kSweepStep_m * unit_vector(frame.heading_rad());
    for (int steps = -1; steps <= 1; ++steps) {
      all.push_back(place);
      all.back().position += steps * step;
    }
  }
  return all;
}

std::vector<CandidateGenerator::Place> CandidateGenerator::nearest_places(Inquiry& inquiry) const {
  constexpr std::size_t kSweepsLookedAt = 3000;
  const auto close_looks = static_cast<std::size_t>(options_.close_looks);
  std::vector<Place> places = std::move(inquiry.places);
  const bool sweeps = inquiry.kind == PatternKind::under_constrained;
  keep_nearest(places, sweeps ? kSweepsLookedAt : close_looks);
  look_closely(places, inquiry, sweeps ? kSweepStep_m / 2 : 0);
  if (!sweeps) return places;
  keep_nearest(places, close_looks);
  places = with_neighbours(places, inquiry);
  look_closely(places, inquiry, 0);
  return places;
}

std::vector<Association> CandidateGenerator::pair_up(const PatternLookup& lookup, int mapped, const Pose2& T_map_base,
                                                     std::span<const SearchFeature> features) const {
  const std::span<const int> members = index_of(lookup).patterns().members(mapped);
  std::vector<Association> pairs;
  for (std::size_t slot = 0; slot < lookup.observed.members.size(); ++slot) {
    const SearchFeature& observed = features[lookup.observed.members[slot]];
    const std::span<const MapFeatureNumber> numbers = members_[members[slot]];
    const Point place = T_map_base * anchor_of(observed.feature.geometry);
    const auto nearer_one = [&](MapFeatureNumber a, MapFeatureNumber b) {
      return distance_m(map_->feature(a).geometry, place) < distance_m(map_->feature(b).geometry, place);
    };
    pairs.push_back({observed.local, *std::min_element(numbers.begin(), numbers.end(), nearer_one)});
  }
  return pairs;
}

CandidateGenerator::Inquiry CandidateGenerator::ask(std::span<const SearchFeature> features,
                                                    std::span<const Point> coarse, PatternKind kind) const {
  Inquiry inquiry(static_cast<std::size_t>(options_.close_looks));
  inquiry.kind = kind;
  inquiry.features = best_per_geometry(features, kFeaturesPerGeometry);
  std::vector<Feature> best;
  for (const SearchFeature& each : inquiry.features) best.push_back(each.feature);
  inquiry.lookups = choose_lookups(templates_, best, options_, kind);
  for (const PatternLookup& lookup : inquiry.lookups) inquiry.points.emplace_back(lookup.observed, coarse);
  return inquiry;
}

CandidateGenerator::Proposal CandidateGenerator::propose(Inquiry inquiry) const {
  Proposal proposal;
  for (const PatternLookup& lookup : inquiry.lookups) {
    proposal.looked_up.push_back({lookup.pattern, {}, lookup.expected});
    for (int member : lookup.observed.members)
      proposal.looked_up.back().local_features.push_back(inquiry.features[member].local);
  }
  std::vector<Place> places = nearest_places(inquiry);
  std::stable_sort(places.begin(), places.end(), nearer);
  std::vector<Pose2> poses;
  for (const Place& place : places) poses.emplace_back(place.position, place.heading_rad);
  for (std::size_t k : distinct_places(poses, kProposedApart, static_cast<std::size_t>(options_.candidates))) {
    const Place& place = places[k];
    const PatternLookup& lookup = inquiry.lookups[place.lookup];
    proposal.candidates.push_back(
        {poses[k], Origin::pattern, lookup.pattern, pair_up(lookup, place.mapped, poses[k], inquiry.features)});
  }
  return proposal;
}

std::vector<std::size_t> distinct_places(std::span<const Pose2> poses, const PoseTolerance& apart, std::size_t most) {
  std::unordered_map<std::int64_t, std::vector<std::size_t>> kept_by_cell;
  const auto cell = [&](double v) { return static_cast<std::int64_t>(std::floor(v / apart.position_m)); };
  const auto key = [](std::int64_t i, std::int64_t j) { return i * 73856093 ^ j * 19349663; };
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < poses.size() && kept.size() < most; ++k) {
    const std::int64_t i = cell(poses[k].x()), j = cell(poses[k].y());
    bool taken = false;
    for (std::int64_t a = i - 1; a <= i + 1 && !taken; ++a)
      for (std::int64_t b = j - 1; b <= j + 1 && !taken; ++b) {
        const auto it = kept_by_cell.find(key(a, b));
        if (it == kept_by_cell.end()) continue;
        for (std::size_t other : it->second) taken = taken || apart.holds(poses[other], poses[k]);
      }
    if (taken) continue;
    kept_by_cell[key(i, j)].push_back(k);
    kept.push_back(k);
  }
  return kept;
}

}  // namespace opal
