#include "benchmark/experiments/buildings/building_groups.hpp"

#include "benchmark/experiments/kit/order_statistics.hpp"

#include <algorithm>

namespace opal::experiments {
namespace {

/// Different values in order of appearance.
template <class T, class Of>
std::vector<T> different(std::span<const BuildingRuns> buildings, const Of& of) {
  std::vector<T> values;
  for (const BuildingRuns& building : buildings)
    if (const T value = of(building); std::ranges::find(values, value) == values.end()) values.push_back(value);
  return values;
}

std::vector<std::string> contenders_of(std::span<const BuildingRuns> buildings) {
  std::vector<std::string> names;
  for (const BuildingRuns& building : buildings)
    for (const ChallengeRun& run : building.runs)
      if (std::ranges::find(names, run.contender) == names.end()) names.push_back(run.contender);
  return names;
}

/// The numbers of a group, building by building.
class Gathering {
 public:
  void add(const BuildingRuns& building, const std::string& contender) {
    Tally success, localized, wrong, unknown;
    after_m_.emplace_back();
    after_s_.emplace_back();
    for (const ChallengeRun& run : building.runs) {
      if (run.contender != contender) continue;
      const Outcome outcome = outcome_of(run);
      const auto count = [](Tally& tally, bool holds) { tally.part += holds, ++tally.whole; };
      count(success, run.success);
      count(localized, outcome == Outcome::localized);
      count(wrong, outcome == Outcome::wrong);
      count(unknown, outcome == Outcome::unknown);
      after_m_.back().push_back(run.localized_after_m.value_or(kNever));
      after_s_.back().push_back(localized_after_s(run));
      cpu_ms_.push_back(run.cpu_ms);
    }
    success_.push_back(success);
    localized_.push_back(localized);
    wrong_.push_back(wrong);
    unknown_.push_back(unknown);
  }

  void sum_up(BuildingGroup& group) const {
    group.buildings = success_.size();
    group.runs = cpu_ms_.size();
    group.success = share_over(success_);
    group.localized = share_over(localized_);
    group.wrong = share_over(wrong_);
    group.unknown = share_over(unknown_);
    group.localized_after_m = median_over(after_m_);
    group.localized_after_s = median_over(after_s_);
    group.cpu_ms = median(cpu_ms_);
  }

 private:
  std::vector<Tally> success_, localized_, wrong_, unknown_;
  std::vector<std::vector<double>> after_m_, after_s_;
  std::vector<double> cpu_ms_;
};

}  // namespace

std::string BuildingGroup::name() const {
  if (kind.empty() && !difficulty) return "all";
  const std::string how = difficulty ? "difficulty " + number(*difficulty, 2) : "";
  return kind + (kind.empty() || how.empty() ? "" : ", ") + how;
}

std::vector<BuildingGroup> groups_of(std::span<const BuildingRuns> buildings) {
  const auto kinds = different<std::string>(buildings, [](const BuildingRuns& b) { return b.building.request.kind; });
  const auto difficulties = different<double>(buildings, [](const BuildingRuns& b) { return b.building.difficulty; });
  std::vector<BuildingGroup> groups;
  const auto add = [&](const std::string& contender, const std::string& kind, std::optional<double> difficulty) {
    BuildingGroup group{kind, difficulty, contender, 0, 0, {}, {}, {}, {}, {}, {}, 0};
    Gathering gathering;
    for (const BuildingRuns& building : buildings)
      if ((kind.empty() || kind == building.building.request.kind) &&
          (!difficulty || *difficulty == building.building.difficulty))
        gathering.add(building, contender);
    gathering.sum_up(group);
    if (group.buildings > 0) groups.push_back(std::move(group));
  };
  for (const std::string& contender : contenders_of(buildings)) {
    add(contender, "", std::nullopt);
    for (const std::string& kind : kinds) add(contender, kind, std::nullopt);
    for (double difficulty : difficulties) add(contender, "", difficulty);
    for (const std::string& kind : kinds)
      for (double difficulty : difficulties) add(contender, kind, difficulty);
  }
  return groups;
}

}  // namespace opal::experiments
