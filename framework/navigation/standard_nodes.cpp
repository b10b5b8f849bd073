#include "navigation/actions.hpp"
#include "navigation/control_nodes.hpp"
#include "navigation/node_registry.hpp"

namespace opal::navigation {
namespace {

using Arity = NodeRegistry::Arity;
using Memory = ControlFlow::Memory;

/// Asks something and is done.
class Condition : public Node {
 public:
  using Question = bool (*)(const Blackboard&);
  explicit Condition(Question question) : question_(question) {}
  NodeStatus tick(Blackboard& blackboard) override {
    return question_(blackboard) ? NodeStatus::success : NodeStatus::failure;
  }

 private:
  Question question_;
};

void add_controls(NodeRegistry& registry) {
  const auto succession = [&](const char* name, NodeStatus go_on, Memory memory) {
    registry.add(name, Arity::some, [=](ConfigObject&, Children children) {
      return std::make_unique<ControlFlow>(go_on, memory, std::move(children));
    });
  };
  succession("opal:Sequence", NodeStatus::success, Memory::keeps_place);
  succession("opal:ReactiveSequence", NodeStatus::success, Memory::starts_over);
  succession("opal:Fallback", NodeStatus::failure, Memory::keeps_place);
  succession("opal:ReactiveFallback", NodeStatus::failure, Memory::starts_over);
  registry.add("opal:Inverter", Arity::one,
               [](ConfigObject&, Children children) { return std::make_unique<Inverter>(std::move(children[0])); });
  registry.add("opal:Once", Arity::one,
               [](ConfigObject&, Children children) { return std::make_unique<Once>(std::move(children[0])); });
  registry.add("opal:ForceFailure", Arity::one, [](ConfigObject&, Children children) {
    return std::make_unique<Forced>(NodeStatus::failure, std::move(children[0]));
  });
  registry.add("opal:ForceSuccess", Arity::one, [](ConfigObject&, Children children) {
    return std::make_unique<Forced>(NodeStatus::success, std::move(children[0]));
  });
}

void add_conditions(NodeRegistry& registry) {
  const auto condition = [&](const char* name, Condition::Question question) {
    registry.add(name, Arity::none,
                 [=](ConfigObject&, const Children&) { return std::make_unique<Condition>(question); });
  };
  condition("opal:IsLocalized", [](const Blackboard& s) { return s.estimate().status == Status::localized; });
  condition("opal:HasPose",
            [](const Blackboard& s) { return s.estimate().has_pose && s.estimate().status != Status::lost; });
  condition("opal:HasAlternatives",
            [](const Blackboard& s) { return s.estimate().has_pose && !s.estimate().alternatives.empty(); });
  condition("opal:IsStuck", [](const Blackboard& s) { return s.is_stuck(); });
}

void add_actions(NodeRegistry& registry) {
  registry.add("opal:Rotate", Arity::none, [](ConfigObject& options, const Children&) {
    const double turns = options.number("turns", 1, {-10, 10});
    return std::make_unique<Rotate>(turns, options.number("turn_radps", 0.9, {0.05, 3}));
  });
  registry.add("opal:DriveFreely", Arity::none, [](ConfigObject& options, const Children&) {
    return std::make_unique<DriveFreely>(options.number("distance_m", 0, {0, 1000}));
  });
  registry.add("opal:KeepPattern", Arity::none,
               [](ConfigObject&, const Children&) { return std::make_unique<KeepPattern>(); });
  registry.add("opal:DriveBetweenFeatures", Arity::none,
               [](ConfigObject&, const Children&) { return std::make_unique<DriveBetweenFeatures>(); });
  registry.add("opal:Disambiguate", Arity::none, [](ConfigObject& options, const Children&) {
    DisambiguateOptions wanted;
    wanted.view_m = options.number("view_m", wanted.view_m, {1, 100});
    wanted.most_places = options.integer("most_places", wanted.most_places, {2, 20});
    wanted.least_separation = options.number("least_separation", wanted.least_separation, {0, 1});
    return std::make_unique<Disambiguate>(wanted);
  });
  registry.add("opal:GoToGoal", Arity::none, [](ConfigObject& options, const Children&) {
    return std::make_unique<GoToGoal>(options.number("arrived_m", 0.25, {0.05, 10}));
  });
  registry.add("opal:BackOff", Arity::none, [](ConfigObject& options, const Children&) {
    return std::make_unique<BackOff>(options.number("distance_m", 0.4, {0.01, 5}));
  });
}

}  // namespace

NodeRegistry standard_nodes() {
  NodeRegistry registry;
  add_controls(registry);
  add_conditions(registry);
  add_actions(registry);
  return registry;
}

}  // namespace opal::navigation
