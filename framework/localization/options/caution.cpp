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

/// A map of another building explains what is seen better than a damaged map of this one does. A sound map is told from
/// both. A place that fits by chance mostly has less than twice the evidence of the next one. On a sound map a scan
/// that says much less than usual is rare, so it is reason enough to think of a kidnapping, and two fair scans do not
/// take that back. docs/notebook/evidence.md, 2026-11-28 and 2026-11-29.
LocalizerOptions strict_options() {
  LocalizerOptions options = careful_options();
  options.status.localized_lead = 0.5;
  options.status.localized_lead_nat = 40;
  options.status.localized_drive_agreement = 0.85;
  options.kidnapping.doubted_share = 0.75;
  options.kidnapping.doubted_weight = 2;
  return options;
}

}  // namespace

LocalizerOptions options_of(Caution caution) {
  switch (caution) {
    case Caution::usual: return {};
    case Caution::careful: return careful_options();
    case Caution::strict: return strict_options();
  }
  return {};
}

}  // namespace opal
