#include <opal/localization/options/caution.hpp>

#include <limits>

namespace opal {
namespace {

/// Where two places differ little, errors of the map decide between them: no lead of a fixed size is enough then. What
/// a search leaves out cannot contradict, so it keeps twice as much. Where most beams that the map speaks about pass
/// through what it has, it is not believed. docs/notebook/evidence.md, 2026-11-28, has what
/// was tried.
LocalizerOptions careful_options() {
  LocalizerOptions options;
  options.search.close_looks *= 2;
  options.search.candidates *= 2;
  options.search.hypotheses *= 2;
  options.status.localized_weight *= 2;
  options.status.localized_agreement = 0.6;
  options.status.localized_least_agreement = 0.5;
  options.status.localized_lead *= 2;
  options.status.localized_lead_nat = std::numeric_limits<double>::infinity();
  return options;
}

}  // namespace

LocalizerOptions options_of(Caution caution) {
  return caution == Caution::careful ? careful_options() : LocalizerOptions();
}

}  // namespace opal
