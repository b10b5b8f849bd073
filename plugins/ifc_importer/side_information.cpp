#include "side_information.hpp"

#include "side_types.hpp"
#include "step_arguments.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

namespace opal::ifc_importer {
namespace {

// Of these, what they refer to tells more of a thing, but is no part of it.
constexpr std::array kSoft{"IFCRELASSOCIATESMATERIAL", "IFCRELDEFINESBYTYPE", "IFCTYPEOBJECT", "IFCTYPEPRODUCT"};
// Of a GlobalId; some exporters write longer ones.
constexpr std::size_t kShortestGlobalId = 22;
constexpr std::size_t kShownNumbers = 5;

bool has_identity(const StepInstance& instance) { return instance.global_id.size() >= kShortestGlobalId; }

/// What has a name is no mere part of something else: a thing, a relation, the axis of a grid.
bool is_part_of_building(const StepInstance& instance) {
  return !instance.global_id.empty() && !instance.type.starts_with("IFCMATERIAL") &&
         !is_side_information(instance.type);
}

bool is_soft(const StepInstance& instance) {
  const bool is_type = instance.type.ends_with("TYPE") || instance.type.ends_with("STYLE");
  return (has_identity(instance) && is_type) || std::find(kSoft.begin(), kSoft.end(), instance.type) != kSoft.end();
}

/// The reference that stands alone at a place among the arguments; -1: none does.
int reference_at(const StepInstance& instance, std::size_t place) {
  const std::vector<std::string_view> arguments = split_arguments(instance.arguments);
  return place < arguments.size() ? referred_by(trimmed(arguments[place])) : -1;
}

/// Who made and changed it: the second argument of everything with an identity. -1: not said.
int owner_of(const StepInstance& instance) { return has_identity(instance) ? reference_at(instance, 1) : -1; }

/// Of a site or a building: the last argument. -1: not said.
int address_of(const StepInstance& instance) {
  if (instance.type != "IFCSITE" && instance.type != "IFCBUILDING") return -1;
  return reference_at(instance, split_arguments(instance.arguments).size() - 1);
}

bool is_spatial(std::string_view type) {
  return type == "IFCPROJECT" || type == "IFCSITE" || type == "IFCBUILDING" || type == "IFCBUILDINGSTOREY" ||
         type == "IFCSPACE";
}

/// Finds what is unsound: what refers to nothing or in a circle, and what cannot do without such an instance.
class Soundness {
 public:
  Soundness(const std::vector<StepInstance>& instances, bool is_cut_off)
      : instances_(instances), is_cut_off_(is_cut_off), state_(instances.size()), fault_(instances.size()) {
    for (std::size_t k = 0; k < instances.size(); ++k) by_number_.emplace(instances[k].number, k);
    for (std::size_t k = 0; k < instances.size(); ++k)
      if (state_[k] == State::unseen) visit_from(k);
  }

  struct Fault {
    std::size_t instance = 0;  ///< where it begins
    int reference = 0;         ///< to what
    bool is_circle = false;
  };
  const std::optional<Fault>& fault(std::size_t instance) const { return fault_[instance]; }

  /// Whether an instance stays sound without the reference: it tells more, or what it names is beside the building.
  bool may_go(std::size_t from, int number) const {
    const StepInstance& instance = instances_[from];
    if (is_soft(instance) || owner_of(instance) == number || address_of(instance) == number) return true;
    if (instance.type == "IFCRELAGGREGATES" && is_part_of_space(instance, number)) return true;
    if (is_cut_off_ && instance.type.starts_with("IFCREL") && !stands_alone(instance, number)) return true;
    const auto found = by_number_.find(number);
    return found != by_number_.end() && is_side_information(instances_[found->second].type) &&
           !is_side_information(instance.type);
  }
  bool leads_nowhere(int number) const {
    const auto found = by_number_.find(number);
    return found == by_number_.end() || fault_[found->second].has_value();
  }

 private:
  /// A space of a storey, or a storey of a building. (What stands in a missing storey refers to it, and is refused.)
  bool is_part_of_space(const StepInstance& relation, int number) const {
    const int whole = reference_at(relation, 4);
    const auto found = by_number_.find(whole);
    return whole != number && found != by_number_.end() && is_spatial(instances_[found->second].type);
  }

  /// Not in a list.
  static bool stands_alone(const StepInstance& instance, int number) {
    const std::vector<std::string_view> arguments = split_arguments(instance.arguments);
    return std::any_of(arguments.begin(), arguments.end(),
                       [&](std::string_view argument) { return referred_by(trimmed(argument)) == number; });
  }

  enum class State : char { unseen, open, done };
  struct Step {
    std::size_t instance, next_reference;
  };

  /// Depth first, without recursion; faults go up the path.
  void visit_from(std::size_t start) {
    std::vector<Step> path{{start, 0}};
    state_[start] = State::open;
    while (!path.empty()) {
      const std::size_t at = path.back().instance;
      if (path.back().next_reference == instances_[at].references.size()) {
        state_[at] = State::done;
        path.pop_back();
        if (!path.empty()) inherit(path.back().instance, at);
      } else if (const auto next = follow(at, instances_[at].references[path.back().next_reference++])) {
        state_[*next] = State::open;
        path.push_back({*next, 0});
      }
    }
  }

  void inherit(std::size_t instance, std::size_t from) {
    if (fault_[from] && !fault_[instance] && !may_go(instance, instances_[from].number))
      fault_[instance] = fault_[from];
  }

  /// An instance that was not seen before, to be visited.
  std::optional<std::size_t> follow(std::size_t from, int number) {
    const auto found = by_number_.find(number);
    if (found == by_number_.end()) {
      if (!fault_[from] && !may_go(from, number)) fault_[from] = Fault{from, number, false};
      return std::nullopt;
    }
    if (state_[found->second] == State::unseen) return found->second;
    if (state_[found->second] == State::open && !may_go(from, number)) fault_[from] = Fault{from, number, true};
    inherit(from, found->second);
    return std::nullopt;
  }

  const std::vector<StepInstance>& instances_;
  bool is_cut_off_;
  std::unordered_map<int, std::size_t> by_number_;
  std::vector<State> state_;
  std::vector<std::optional<Fault>> fault_;
};

std::string numbers_of(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t k = 0; k < std::min(numbers.size(), kShownNumbers); ++k) text += fmt::format(" #{}", numbers[k]);
  return text + (numbers.size() > kShownNumbers ? " ..." : "");
}

/// Instances by their type, for the report.
using ByType = std::map<std::string, std::vector<int>, std::less<>>;

void tell(const ByType& by_type, const std::string& why, std::vector<std::string>& sentences) {
  for (const auto& [type, numbers] : by_type)
    sentences.push_back(fmt::format("left out: {} {}, {}:{}", numbers.size(), type, why, numbers_of(numbers)));
}

std::string ignored_references(const ByType& by_type) {
  std::vector<std::string> types;
  for (const auto& [type, numbers] : by_type) types.push_back(fmt::format("{} {}", numbers.size(), type));
  return fmt::format("ignored: what the file does not define, or was left out, where these refer to it: {}",
                     fmt::join(types, ", "));
}

/// Openings that no relation cuts from a wall: in a file that is cut off, these are doors that stay closed.
std::vector<int> unused_openings(const std::vector<StepInstance>& instances) {
  std::set<int> used;
  for (const StepInstance& instance : instances)
    if (instance.type == "IFCRELVOIDSELEMENT") used.insert(instance.references.begin(), instance.references.end());
  std::vector<int> unused;
  for (const StepInstance& instance : instances)
    if (instance.type == "IFCOPENINGELEMENT" && !used.contains(instance.number)) unused.push_back(instance.number);
  return unused;
}

[[noreturn]] void refuse(const StepInstance& instance, const Soundness::Fault& fault, const std::string& name) {
  const std::string begin =
      fmt::format("{}: #{} ({}) refers to #{}", name, instance.number, instance.type, fault.reference);
  throw MapError(begin + (fault.is_circle ? " and so in a circle to itself" : ", which the file does not define"));
}

}  // namespace

std::vector<std::string> leave_out_unsound(std::vector<StepInstance>& instances, const std::string& name,
                                           bool is_cut_off) {
  const Soundness soundness(instances, is_cut_off);
  ByType circles, incomplete, cut_off, shortened;
  std::vector<StepInstance> sound;
  sound.reserve(instances.size());
  for (std::size_t k = 0; k < instances.size(); ++k) {
    StepInstance& instance = instances[k];
    if (const auto& fault = soundness.fault(k)) {
      const bool is_refused = fault->is_circle || !is_cut_off;
      if (is_refused && is_part_of_building(instance)) refuse(instances[fault->instance], *fault, name);
      (fault->is_circle ? circles
       : is_cut_off     ? cut_off
                        : incomplete)[std::string(instance.type)]
          .push_back(instance.number);
      continue;
    }
    const auto goes = [&](int number) { return soundness.leads_nowhere(number) && soundness.may_go(k, number); };
    std::copy_if(instance.references.begin(), instance.references.end(), std::back_inserter(instance.ignored), goes);
    std::erase_if(instance.references, goes);
    if (!instance.ignored.empty()) shortened[std::string(instance.type)].push_back(instance.number);
    sound.push_back(std::move(instance));
  }
  instances = std::move(sound);
  std::vector<std::string> sentences;
  tell(cut_off, "which need what the file does not define", sentences);
  tell(incomplete, "which need what the file does not define, and are no part of the building", sentences);
  tell(circles, "which refer to each other, and are no part of the building", sentences);
  if (const auto unused = unused_openings(instances); is_cut_off && !unused.empty())
    sentences.push_back(fmt::format("doubtful: openings that are cut from no wall, for the file is cut off: {}:{}",
                                    unused.size(), numbers_of(unused)));
  if (!shortened.empty()) sentences.push_back(ignored_references(shortened));
  return sentences;
}

}  // namespace opal::ifc_importer
