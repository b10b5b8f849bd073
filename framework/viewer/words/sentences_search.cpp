#include "common/phrases.hpp"
#include "report/quantity_text.hpp"
#include "viewer/words/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace opal {
namespace {

/// "6 patterns (opal:LinePair: 5, with 25 candidates; ...)"
std::string lookups_text(const std::vector<RecordedSearch::Lookup>& lookups) {
  struct Total {
    std::size_t patterns = 0, candidates = 0;
  };
  std::map<std::string, Total> totals;
  for (const RecordedSearch::Lookup& lookup : lookups) {
    Total& total = totals[lookup.pattern_template];
    ++total.patterns;
    total.candidates += static_cast<std::size_t>(lookup.candidates);
  }
  std::string text;
  for (const auto& [name, total] : totals)
    text += (text.empty() ? "" : "; ") + name + ": " + std::to_string(total.patterns) + ", with " +
            count_of(total.candidates, "candidate");
  return count_of(lookups.size(), "pattern") + (text.empty() ? "" : " (" + text + ")");
}

/// The rejected place with the best score.
const RecordedSearch::Rejected* best_rejected(const RecordedSearch& search) {
  const auto rank = [](const RecordedSearch::Rejected& rejected) {
    return std::make_tuple(-rejected.nat, rejected.T_map_base.x(), rejected.T_map_base.y(),
                           rejected.T_map_base.heading_rad());
  };
  const auto it =
      std::ranges::min_element(search.rejected, [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return it == search.rejected.end() ? nullptr : &*it;
}

std::string search_text(const RecordedSearch& search, double searched_s) {
  std::string text = "last search, at " + seconds_text(searched_s) + ": looked up " + lookups_text(search.patterns) +
                     ", " + count_of(search.proposed, "place") + " proposed";
  const RecordedSearch::Rejected* best = best_rejected(search);
  if (!best) return text;
  return text + ", " + std::to_string(search.rejected.size()) + " rejected, the best of these at " +
         place_text(best->T_map_base.position()) + " with " + nat_text(best->nat) + ": " + best->reason;
}

std::string senses_text(const ExplainedMoment& moment) {
  const auto& locals = moment.state.local_features();
  const auto stable = std::ranges::count_if(locals, [](const auto& entry) { return entry.second.stable; });
  return fmt::format("the scan has {} (thinned), the local map {}, {} of them stable",
                     count_of(moment.state.frame().scan.size(), "point"), count_of(locals.size(), "feature"), stable);
}

std::string truth_text(const Pose2& truth, const TracedHypothesis& best) {
  const double off_deg = degrees(angle_between_rad(truth, best.T_map_base));
  return "the recorded truth is " + metres_text(distance_m(truth, best.T_map_base)) + " and " + fixed_text(off_deg, 1) +
         " deg away";
}

}  // namespace

void add_search(const ExplainedMoment& moment, std::vector<Sentence>& sentences) {
  const RunFrame& frame = moment.state.frame();
  const TracedHypothesis* best = moment.state.best();
  const auto note = [&](std::string text) { sentences.push_back({SentenceKind::note, std::move(text)}); };
  if (best && frame.none > frame.probability) note("\"none of these\" is more probable than the best hypothesis");
  for (const std::string& finding : frame.sensor)
    if (finding != frame.why) note("sensor: " + finding);
  if (frame.status == "searching" || frame.status == "lost") {
    note(moment.search ? search_text(*moment.search, moment.searched_s) : "no search is recorded so far");
    note(senses_text(moment));
  }
  if (best && frame.truth) note(truth_text(*frame.truth, *best));
}

}  // namespace opal
