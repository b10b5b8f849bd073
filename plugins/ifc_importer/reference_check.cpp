#include "reference_check.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace opal::ifc_importer {
namespace {

// Longest chain in real models: about 40. Objects are taken apart by recursion along such chains.
constexpr std::size_t kLongestChain = 2000;

std::string named(const StepInstance& instance) { return fmt::format("#{} ({})", instance.number, instance.type); }

/// Depth first, without recursion of its own.
class Walk {
 public:
  Walk(const std::vector<StepInstance>& instances, const std::string& name) : instances_(instances), name_(name) {
    for (std::size_t k = 0; k < instances.size(); ++k)
      if (!by_number_.emplace(instances[k].number, k).second)
        fail(instances[k], "is there twice, expected one of each number");
  }

  void run() {
    state_.assign(instances_.size(), State::unseen);
    chain_.assign(instances_.size(), 1);
    for (std::size_t k = 0; k < instances_.size(); ++k)
      if (state_[k] == State::unseen) visit_from(k);
  }

 private:
  enum class State : char { unseen, open, done };
  struct Step {
    std::size_t instance, next_reference;
  };

  [[noreturn]] void fail(const StepInstance& instance, const std::string& complaint) const {
    throw MapError(name_ + ": " + named(instance) + " " + complaint);
  }

  std::size_t target(const StepInstance& from, int number) const {
    const auto found = by_number_.find(number);
    if (found == by_number_.end()) fail(from, fmt::format("refers to #{}, which the file does not define", number));
    return found->second;
  }

  void lengthen(std::size_t instance, std::size_t by) {
    chain_[instance] = std::max(chain_[instance], chain_[by] + 1);
    if (chain_[instance] > kLongestChain)
      fail(instances_[instance], fmt::format("begins a chain of more than {} references", kLongestChain));
  }

  void visit_from(std::size_t start) {
    std::vector<Step> path{{start, 0}};
    state_[start] = State::open;
    while (!path.empty()) {
      const StepInstance& instance = instances_[path.back().instance];
      if (path.back().next_reference == instance.references.size()) {
        state_[path.back().instance] = State::done;
        const std::size_t ended = path.back().instance;
        path.pop_back();
        if (!path.empty()) lengthen(path.back().instance, ended);
        continue;
      }
      const std::size_t next = target(instance, instance.references[path.back().next_reference++]);
      if (state_[next] == State::open)
        fail(instance, "refers to " + named(instances_[next]) + " and so in a circle to itself");
      if (state_[next] == State::done) {
        lengthen(path.back().instance, next);
        continue;
      }
      state_[next] = State::open;
      path.push_back({next, 0});
    }
  }

  const std::vector<StepInstance>& instances_;
  const std::string& name_;
  std::unordered_map<int, std::size_t> by_number_;
  std::vector<State> state_;
  std::vector<std::size_t> chain_;  // longest from there
};

}  // namespace

void check_references(const std::vector<StepInstance>& instances, const std::string& name) {
  Walk(instances, name).run();
}

}  // namespace opal::ifc_importer
