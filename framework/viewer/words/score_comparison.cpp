#include "viewer/words/score_comparison.hpp"

#include "report/quantity_text.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace opal {
namespace {

using TermName = std::pair<std::string, std::string>;  ///< scorer, term

/// A term that people know by other words, and which of two values is the worse one.
struct KnownTerm {
  const char* words;
  bool more_is_worse;
};

const KnownTerm* known_term(const TermName& name) {
  static const std::map<TermName, KnownTerm> known{
      {{"opal:Beams", "hit"}, {"beams on mapped surfaces", false}},
      {{"opal:Beams", "short"}, {"beams that end where nothing is mapped", true}},
      {{"opal:Beams", "through"}, {"beams through mapped surfaces", true}}};
  const auto it = known.find(name);
  return it == known.end() ? nullptr : &it->second;
}

std::string term_text(const TermName& name, double alternative, double best) {
  if (const KnownTerm* known = known_term(name))
    return std::string(known->words) + " " + percent_text(alternative) + ", of the best one " + percent_text(best);
  return name.first + " " + name.second + " " + fixed_text(alternative, 2) + ", of the best one " + fixed_text(best, 2);
}

std::map<TermName, double> terms_of(const TracedHypothesis& hypothesis) {
  std::map<TermName, double> terms;
  for (const RecordedTerm& term : hypothesis.scores) terms[{term.scorer, term.term}] = term.value;
  return terms;
}

struct Difference {
  double worse_by = 0;  ///< 0 for terms whose meaning is not known
  std::string text;
};

/// Known terms that are worse than the best one's, the largest difference first; then all others that differ.
std::vector<Difference> differences(const TracedHypothesis& alternative, const TracedHypothesis& best) {
  constexpr double kShownDifference = 0.01;
  const std::map<TermName, double> of_best = terms_of(best);
  std::vector<Difference> found;
  for (const auto& [name, value] : terms_of(alternative)) {
    const auto it = of_best.find(name);
    if (it == of_best.end() || !(std::abs(value - it->second) >= kShownDifference)) continue;
    const KnownTerm* known = known_term(name);
    const double worse_by = !known ? 0 : known->more_is_worse ? value - it->second : it->second - value;
    if (worse_by >= 0) found.push_back({worse_by, term_text(name, value, it->second)});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.worse_by > b.worse_by; });
  return found;
}

}  // namespace

std::string comparison_text(const TracedHypothesis& alternative, const TracedHypothesis& best) {
  constexpr std::size_t kNamedTerms = 2;
  std::vector<Difference> found = differences(alternative, best);
  if (found.size() > kNamedTerms) found.resize(kNamedTerms);
  std::string text;
  for (const Difference& difference : found) text += difference.text + "; ";
  return text + "gathered " + nat_text(alternative.log_likelihood) + ", the best one " + nat_text(best.log_likelihood);
}

}  // namespace opal
