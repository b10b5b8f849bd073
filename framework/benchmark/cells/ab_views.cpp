#include "benchmark/cells/ab_views.hpp"

#include "benchmark/runs/view_page.hpp"

#include "benchmark/ab/execution/child_process.hpp"
#include "common/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>

namespace opal::benchmark {
namespace {

namespace ab = opal::ab;
namespace fs = std::filesystem;

constexpr std::size_t kMostPerArm = 5;
constexpr double kNever_m = 1000;  // as far as anything is from being right

/// A query in which an arm and the baseline came out differently.
struct Contrast {
  std::size_t task = 0, arm = 0;
  double apart = 0;       ///< in no unit: right or not first, then honesty, then metres until right
  double deciding_s = 0;  ///< since the query's begin
};

double value_or(const ab::CellResult& result, const std::string& name, double otherwise) {
  const auto found = result.values.find(name);
  return found == result.values.end() ? otherwise : found->second;
}

double distance_apart(const ab::CellResult& a, const ab::CellResult& b) {
  return 100 * std::abs(value_or(a, "honest", 0) - value_or(b, "honest", 0)) +
         std::abs(value_or(a, "distance_to_success_m", kNever_m) - value_or(b, "distance_to_success_m", kNever_m));
}

double deciding_s(const ab::CellResult& a, const ab::CellResult& b) {
  const double never = std::numeric_limits<double>::infinity();
  const double first = std::min(value_or(a, "time_to_success_s", never), value_or(b, "time_to_success_s", never));
  return std::isinf(first) ? 0 : first;
}

/// The farthest apart, by arm.
std::vector<Contrast> contrasts_of(const ab::Experiment& experiment, const ab::CellPlan& plan,
                                   const ab::MergedResults& results) {
  std::vector<std::vector<Contrast>> by_arm(plan.arms());
  std::vector<ab::CellResult> cells;
  results.for_each_complete_task([&](const ab::Cell&, const ab::CellResult& result) {
    cells.push_back(result);
    if (cells.size() < plan.arms()) return;
    const ab::CellResult& baseline = cells[experiment.baseline];
    for (std::size_t arm = 0; arm < plan.arms(); ++arm) {
      const bool ran = cells[arm].failure.empty() && baseline.failure.empty();
      const double apart = distance_apart(cells[arm], baseline);
      if (!ran || apart == 0) continue;
      std::vector<Contrast>& all = by_arm[arm];
      all.push_back({result.number / plan.arms(), arm, apart, deciding_s(cells[arm], baseline)});
      std::ranges::stable_sort(all, std::greater{}, &Contrast::apart);
      if (all.size() > kMostPerArm) all.resize(kMostPerArm);
    }
    cells.clear();
  });
  std::vector<Contrast> chosen;
  for (const auto& all : by_arm) chosen.insert(chosen.end(), all.begin(), all.end());
  std::ranges::stable_sort(chosen, {}, &Contrast::task);  // world by world
  return chosen;
}

std::string file_name(std::string cell) {
  std::replace(cell.begin(), cell.end(), '/', '_');
  return cell;
}

}  // namespace

ViewLinks write_views(const ab::Experiment& experiment, const ab::CellPlan& plan, const ab::ResultFolder& folder,
                      const ab::MergedResults& results, LocalizingRunner& runner) {
  const fs::path views = folder.file("views");
  make_folder(views.string());
  std::map<std::string, std::string> links;  // by cell
  for (const Contrast& contrast : contrasts_of(experiment, plan, results)) {
    const ab::Task task = plan.task(contrast.task);
    runner.enter(task);
    std::vector<ViewedRun> runs;
    for (const std::size_t arm : {experiment.baseline, contrast.arm}) {
      const std::string run = (views / file_name(plan.name({task, arm}))).string();
      ab::ChildProcess child([&](const ab::ChildProcess::Say&) { runner.record(task, arm, run); });
      if (ab::next_answer(child, experiment.limits.wall_s, experiment.limits.memory_mb).failure.empty())
        runs.push_back({run, plan.arm({task, arm})});
    }
    const std::string name = file_name(plan.name({task, contrast.arm})) + ".html";
    if (runs.size() == 2) {
      write_view_page(runs, (views / name).string());
      const std::string link = "views/" + name + fmt::format("#t={:.1f}", contrast.deciding_s);
      links[plan.name({task, contrast.arm})] = link + "&run=1";
      links.emplace(plan.name({task, experiment.baseline}), link);
    }
    for (const ViewedRun& run : runs) fs::remove_all(run.out);
  }
  return [links](const opal::statistics::ResultRow& row) {
    const auto found = links.find(fmt::format("{}/{}/{}/{}", row.cluster, row.query, row.seed, row.arm));
    return found == links.end() ? std::string() : found->second;
  };
}

}  // namespace opal::benchmark
