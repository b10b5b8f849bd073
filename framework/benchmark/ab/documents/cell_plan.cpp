#include "benchmark/ab/documents/cell_plan.hpp"

#include <opal/common/error.hpp>
#include <opal/common/number_text.hpp>

#include <fmt/format.h>

#include <algorithm>

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
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto number = parse_number<std::size_t>(text.substr(0, slash));
  const auto of = parse_number<std::size_t>(text.substr(std::min(slash + 1, text.size())));
  if (!number || !of || *number < 1 || *number > *of)
    throw ConfigError("--shard: \"" + text + "\", expected PART/PARTS, as 3/10: the third of ten parts");
  return {*number, *of};
}

}  // namespace opal::ab
