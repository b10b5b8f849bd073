#pragma once

#include "viewer/reading/run_state.hpp"

#include <string>

namespace opal {

/// What a hypothesis scores less than the best one, from the terms that the scorers recorded for both of them. Of
/// `opal:Beams` it knows what the terms mean; of other scorers it gives name and values.
/// "beams through mapped surfaces 31 %, of the best one 2 %; gathered 12.10 nat, the best one 15.30 nat"
std::string comparison_text(const TracedHypothesis& alternative, const TracedHypothesis& best);

}  // namespace opal
