#include "localization/search/pattern_lookup.hpp"

#include <algorithm>
#include <limits>

namespace opal {
namespace {

double support_of(const PatternInstance& observed, std::span<const Feature> features) {
  double least = std::numeric_limits<double>::infinity();
  for (int member : observed.members) least = std::min(least, weight_of(features[member]));
  return least;
}

/// Where the robot may be if a lookup is right.
std::size_t places_of(const PatternLookup& lookup) {
  constexpr std::size_t kPlacesPerSweep = 3;
  return lookup.expected * (is_under_constrained(lookup.observed) ? kPlacesPerSweep : 1);
}

/// More places are not looked at in time: when the search is through, the robot is elsewhere.
std::size_t most_places_in_time(const SearchOptions& options) {
  constexpr std::size_t kScans = 15;
  return options.places_per_scan > 0 ? kScans * static_cast<std::size_t>(options.places_per_scan)
                                     : std::numeric_limits<std::size_t>::max();
}

/// Those that are expected least often, as long as they have no more places together; the fewest in any case, unless
/// they have a multiple of that: a few rare ones are soon looked up, and the next scan has others.
void keep_rarest(std::vector<PatternLookup>& lookups, std::size_t most_places, std::size_t fewest) {
  std::ranges::stable_sort(lookups, {}, &PatternLookup::expected);
  constexpr std::size_t kMultiple = 5;
  std::size_t places = 0, kept = 0;
  for (const PatternLookup& lookup : lookups) {
    places += places_of(lookup);
    if (kept > 0 && places > (kept < fewest ? kMultiple : 1) * most_places) break;
    ++kept;
  }
  lookups.erase(lookups.begin() + static_cast<std::ptrdiff_t>(kept), lookups.end());
}

/// Well supported ones of one template; of those, the ones that the map has, and that the index expects least often.
std::vector<PatternLookup> shortlist(const MappedTemplate& mapped, TemplateNumber pattern,
                                     std::span<const Feature> features, const SearchOptions& options,
                                     PatternKind kind) {
  std::vector<PatternLookup> lookups;
  for (PatternInstance& observed : find_patterns(*mapped.part, features))
    if (kind_of(observed) == kind) lookups.push_back({pattern, std::move(observed), 0});
  std::ranges::stable_sort(lookups, [&](const PatternLookup& a, const PatternLookup& b) {
    return support_of(a.observed, features) > support_of(b.observed, features);
  });
  const bool is_free = kind == PatternKind::under_constrained;
  const auto most = static_cast<std::size_t>(is_free ? options.under_constrained_patterns : options.patterns);
  if (lookups.size() > most) lookups.erase(lookups.begin() + static_cast<std::ptrdiff_t>(most), lookups.end());
  const std::size_t in_time = most_places_in_time(options);
  for (PatternLookup& lookup : lookups) lookup.expected = mapped.index.count(lookup.observed, in_time);
  std::erase_if(
      lookups, [in_time](const PatternLookup& lookup) { return lookup.expected == 0 || places_of(lookup) >= in_time; });
  keep_rarest(lookups, static_cast<std::size_t>(options.lookup_limit), 1);
  return lookups;
}

/// A pattern that contains others says all that they say, and fewer places look like it: its parts are not looked up
/// (Algorithm 3, Hendrikx 2023).
void leave_out_parts(std::vector<PatternLookup>& chosen) {
  const auto is_part = [](const std::vector<int>& part, const std::vector<int>& whole) {
    return part.size() < whole.size() &&
           std::ranges::all_of(part, [&](int member) { return std::ranges::find(whole, member) != whole.end(); });
  };
  std::vector<std::vector<int>> wholes;
  for (const PatternLookup& lookup : chosen) wholes.push_back(lookup.observed.members);
  std::erase_if(chosen, [&](const PatternLookup& lookup) {
    return std::ranges::any_of(wholes, [&](const auto& whole) { return is_part(lookup.observed.members, whole); });
  });
}

}  // namespace

double weight_of(const Feature& feature) {
  if (const auto* segment = std::get_if<Segment>(&feature.geometry))
    return feature.support_m > 0 ? feature.support_m : segment->length_m();
  return -anchor_of(feature.geometry).norm();
}

std::vector<PatternLookup> choose_lookups(std::span<const MappedTemplate> templates, std::span<const Feature> features,
                                          const SearchOptions& options, PatternKind kind) {
  constexpr std::size_t kFewest = 3;
  std::vector<PatternLookup> chosen;
  for (std::size_t k = 0; k < templates.size(); ++k)
    for (PatternLookup& lookup : shortlist(templates[k], TemplateNumber(k), features, options, kind))
      chosen.push_back(std::move(lookup));
  if (options.places > 0) keep_rarest(chosen, static_cast<std::size_t>(options.places), kFewest);
  leave_out_parts(chosen);
  return chosen;
}

}  // namespace opal
