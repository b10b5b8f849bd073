#include "navigation/control_nodes.hpp"

namespace opal::behaviours {

Outcome Succession::tick(Situation& situation) {
  for (std::size_t k = memory_ == Memory::starts_over ? 0 : at_; k < children_.size(); ++k) {
    const Outcome outcome = children_[k]->tick(situation);
    if (outcome == go_on_) continue;
    halt_but(k);
    at_ = outcome == Outcome::running ? k : 0;
    return outcome;
  }
  at_ = 0;
  return go_on_;
}

/// Where a child before the running one has taken over.
void Succession::halt_but(std::size_t running) {
  for (std::size_t k = running + 1; k < children_.size(); ++k) children_[k]->halt();
}

void Succession::halt() {
  at_ = 0;
  for (const auto& child : children_) child->halt();
}

Outcome Inverter::tick(Situation& situation) {
  switch (child_->tick(situation)) {
    case Outcome::success: return Outcome::failure;
    case Outcome::failure: return Outcome::success;
    case Outcome::running: break;
  }
  return Outcome::running;
}

}  // namespace opal::behaviours
