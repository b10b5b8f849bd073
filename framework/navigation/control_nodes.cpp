#include "navigation/control_nodes.hpp"

namespace opal::navigation {

NodeStatus ControlFlow::tick(Blackboard& blackboard) {
  for (std::size_t k = memory_ == Memory::starts_over ? 0 : at_; k < children_.size(); ++k) {
    const NodeStatus outcome = children_[k]->tick(blackboard);
    if (outcome == go_on_) continue;
    halt_but(k);
    at_ = outcome == NodeStatus::running ? k : 0;
    return outcome;
  }
  at_ = 0;
  return go_on_;
}

/// Where a child before the running one has taken over.
void ControlFlow::halt_but(std::size_t running) {
  for (std::size_t k = running + 1; k < children_.size(); ++k) children_[k]->halt();
}

void ControlFlow::halt() {
  at_ = 0;
  for (const auto& child : children_) child->halt();
}

NodeStatus Inverter::tick(Blackboard& blackboard) {
  switch (child_->tick(blackboard)) {
    case NodeStatus::success: return NodeStatus::failure;
    case NodeStatus::failure: return NodeStatus::success;
    case NodeStatus::running: break;
  }
  return NodeStatus::running;
}

}  // namespace opal::navigation
