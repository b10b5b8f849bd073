#pragma once

#include "navigation/node.hpp"

namespace opal::behaviours {

/// Ticks its children one after the other while they come out as `go_on`; ends with the first that comes out otherwise,
/// or as `go_on` after the last.
class Succession : public Node {
 public:
  enum class Memory {
    keeps_place,  ///< goes on at the child that was running
    starts_over   ///< asks all children before it again, and halts it if one of them now ends the succession
  };
  Succession(Outcome go_on, Memory memory, Children children)
      : go_on_(go_on), memory_(memory), children_(std::move(children)) {}

  Outcome tick(Situation& situation) override;
  void halt() override;

 private:
  void halt_but(std::size_t running);

  Outcome go_on_;
  Memory memory_;
  Children children_;
  std::size_t at_ = 0;
};

/// Turns success into failure and the other way round.
class Inverter : public Node {
 public:
  explicit Inverter(std::unique_ptr<Node> child) : child_(std::move(child)) {}
  Outcome tick(Situation& situation) override;
  void halt() override { child_->halt(); }

 private:
  std::unique_ptr<Node> child_;
};

/// Comes out as given once its child has ended.
class Forced : public Node {
 public:
  Forced(Outcome outcome, std::unique_ptr<Node> child) : outcome_(outcome), child_(std::move(child)) {}
  Outcome tick(Situation& situation) override {
    return child_->tick(situation) == Outcome::running ? Outcome::running : outcome_;
  }
  void halt() override { child_->halt(); }

 private:
  Outcome outcome_;
  std::unique_ptr<Node> child_;
};

/// Does its child to its end once in a run; then comes out as the child did.
class Once : public Node {
 public:
  explicit Once(std::unique_ptr<Node> child) : child_(std::move(child)) {}
  Outcome tick(Situation& situation) override {
    if (outcome_ == Outcome::running) outcome_ = child_->tick(situation);
    return outcome_;
  }
  void halt() override { child_->halt(); }

 private:
  std::unique_ptr<Node> child_;
  Outcome outcome_ = Outcome::running;
};

}  // namespace opal::behaviours
