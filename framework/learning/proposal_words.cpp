#include "learning/learned_overlay.hpp"

#include <fmt/format.h>

namespace opal {

const char* name_of(Change change) {
  switch (change) {
    case Change::moved: return "moved";
    case Change::gone: return "gone";
    case Change::added: return "added";
  }
  return "";
}

std::string objection_to(const Proposal& proposal) {
  std::string words = proposal.is_conflicting ? "visits place it differently" : "";
  if (proposal.moves_about) words += (words.empty() ? "" : "; ") + std::string("there on one visit and not on another");
  return words;
}

std::string sentence_of(const Proposal& proposal) {
  std::string words;
  switch (proposal.change) {
    case Change::moved:
      words = fmt::format("stands elsewhere by {:.2f} m, {:.2f} m (+- {:.2f} m)", proposal.moved.x(),
                          proposal.moved.y(), proposal.sigma_m);
      break;
    case Change::gone: words = "is gone: beams pass through it"; break;
    case Change::added: words = fmt::format("a face of {:.1f} m that the map lacks", proposal.face.length_m()); break;
  }
  words += fmt::format("; on {} of {} visits, probability {:.3f}; ", proposal.visits_for,
                       proposal.visits_for + proposal.visits_against, proposal.probability);
  if (const std::string objection = objection_to(proposal); !objection.empty()) words += objection + "; ";
  return words + fmt::format("drives: {}", fmt::join(proposal.drives, ", "));
}

std::string sentence_of(const Proposal& proposal, const VisitSight& sight) {
  const bool is_gone =
      proposal.change == Change::added ? !sight.agrees : sight.verdict == DeviationVerdict::probably_absent;
  if (is_gone) return fmt::format("beams pass through it, {:.0f} of 100 looks", 100 * sight.seen_through_share);
  std::string words = "where the map says";
  if (proposal.change == Change::added)
    words = fmt::format("a face of {:.1f} m", sight.face.length_m());
  else if (sight.verdict == DeviationVerdict::moved)
    words =
        fmt::format("elsewhere by {:.2f} m, {:.2f} m (+- {:.2f} m)", sight.moved.x(), sight.moved.y(), sight.sigma_m);
  return words + fmt::format("; {} keyframes", sight.keyframes);
}

}  // namespace opal
