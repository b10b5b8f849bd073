#include "benchmark/ab/documents/cell_plan.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace opal::ab {

CellPlan::CellPlan(const Experiment& experiment, std::vector<std::vector<std::string>> queries) : first_task_{0} {
  for (const Arm& arm : experiment.arms) arms_.push_back(arm.name);
  for (std::size_t k = 0; k < experiment.scenarios.size(); ++k) {
    const Scenario& scenario = experiment.scenarios[k];
    scenarios_.push_back({scenario.name, scenario.seeds, std::move(queries[k])});
    first_task_.push_back(first_task_.back() + scenarios_[k].seeds.size() * scenarios_[k].queries.size());
  }
  if (tasks() == 0) throw ConfigError(experiment.file + ": no queries in any scenario, expected at least one");
}

Task CellPlan::task(std::size_t number) const {
  const auto after = std::upper_bound(first_task_.begin(), first_task_.end(), number);
  const auto scenario = static_cast<std::size_t>(after - first_task_.begin()) - 1;
  const Tasks& tasks = scenarios_[scenario];
  const std::size_t within = number - first_task_[scenario];
  return {scenario, tasks.seeds[within / tasks.queries.size()], within % tasks.queries.size()};
}

std::string CellPlan::name(const Cell& cell) const {
  return fmt::format("{}/{}/{}/{}", scenario(cell.task), query(cell.task), cell.task.seed, arm(cell));
}

std::size_t CellPlan::end_of_block(std::size_t first, std::size_t last) const {
  constexpr std::size_t kFew = 4;
  const Task begin = task(first);
  const bool many_worlds = scenarios_[begin.scenario].seeds.size() > 1;
  const std::size_t most = many_worlds ? scenarios_[begin.scenario].queries.size() : kFew;
  std::size_t end = first + 1;
  while (end < last && end < first + most && task(end).same_world(begin)) ++end;
  return end;
}

Shard read_shard(const std::string& text) {
  Shard shard{0, 0};
  const auto slash = text.find('/');
  const auto number = [&](std::size_t from, std::size_t to, std::size_t& value) {
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + to, value);
    return error == std::errc() && end == text.data() + to;
  };
  const bool good =
      slash != std::string::npos && number(0, slash, shard.number) && number(slash + 1, text.size(), shard.of);
  if (!good || shard.number < 1 || shard.number > shard.of)
    throw ConfigError("--shard: \"" + text + "\", expected PART/PARTS, as 3/10: the third of ten parts");
  return shard;
}

}  // namespace opal::ab
