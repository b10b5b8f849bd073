#pragma once

#include "navigation/node.hpp"

namespace opal::navigation {

/// Ticks its children one after the other while they come out as `go_on`; ends with the first that comes out otherwise,
/// or as `go_on` after the last.
class ControlFlow : public Node {
 public:
  enum class Memory {
    keeps_place,  ///< goes on at the child that was running
    starts_over   ///< asks all children before it again, and halts it if one of them now ends the succession
  };
  ControlFlow(NodeStatus go_on, Memory memory, Children children)
      : go_on_(go_on), memory_(memory), children_(std::move(children)) {}

  NodeStatus tick(Blackboard& blackboard) override;
  void halt() override;

 private:
  void halt_but(std::size_t running);

  NodeStatus go_on_;
  Memory memory_;
  Children children_;
  std::size_t at_ = 0;
};

/// Turns success into failure and the other way round.
class Inverter : public Node {
 public:
  explicit Inverter(std::unique_ptr<Node> child) : child_(std::move(child)) {}
  NodeStatus tick(Blackboard& blackboard) override;
  void halt() override { child_->halt(); }

 private:
  std::unique_ptr<Node> child_;
};

/// Comes out as given once its child has ended.
class Forced : public Node {
 public:
  Forced(NodeStatus outcome, std::unique_ptr<Node> child) : outcome_(outcome), child_(std::move(child)) {}
  NodeStatus tick(Blackboard& blackboard) override {
    return child_->tick(blackboard) == NodeStatus::running ? NodeStatus::running : outcome_;
  }
  void halt() override { child_->halt(); }

 private:
  NodeStatus outcome_;
  std::unique_ptr<Node> child_;
};

/// Does its child to its end once in a run; then comes out as the child did.
class Once : public Node {
 public:
  explicit Once(std::unique_ptr<Node> child) : child_(std::move(child)) {}
  NodeStatus tick(Blackboard& blackboard) override {
    if (outcome_ == NodeStatus::running) outcome_ = child_->tick(blackboard);
    return outcome_;
  }
  void halt() override { child_->halt(); }

 private:
  std::unique_ptr<Node> child_;
  NodeStatus outcome_ = NodeStatus::running;
};

}  // namespace opal::navigation
