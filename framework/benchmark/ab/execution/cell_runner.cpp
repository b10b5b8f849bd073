#include "benchmark/ab/execution/cell_runner.hpp"

#include "benchmark/ab/execution/child_process.hpp"

#include <chrono>
#include <limits>

namespace opal::ab {
namespace {

constexpr const char* kReady = "ready";
constexpr double kPatience_s = 30;  // beyond a cell's own limit, for the process that watches it

/// In the process in which the arm is set up.
CellResult run_cell(CellRunner& runner, const Task& task, const CellLimits& limits) {
  const auto start = std::chrono::steady_clock::now();
  ChildProcess child([&](const ChildProcess::Say& say) {
    CellResult result;
    runner.run(task, result);
    say(journal_line(result));
  });
  const Answer answer = next_answer(child, limits.wall_s, limits.memory_mb);
  CellResult result;
  if (answer.given) {
    result = parse_journal_line(answer.line, "a cell");
    std::string nothing;
    while (child.hear(nothing, kPatience_s) == ChildProcess::Heard::line) continue;
  } else {
    result.failure = answer.failure.empty() ? "ended without a result" : answer.failure;
  }
  child.end();
  result.costs["peak_mb"] = child.peak_mb();
  result.costs["wall_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

/// The worker's side of one process in which the arm is set up. Tasks that are done are taken off the front.
class ArmProcess {
 public:
  ArmProcess(CellRunner& runner, const CellPlan& plan, std::size_t arm, const CellLimits& limits)
      : runner_(runner), plan_(plan), arm_(arm), limits_(limits) {}

  void run(std::vector<std::size_t>& tasks, const std::function<void(const CellResult&)>& finished) {
    ChildProcess child([&](const ChildProcess::Say& say) {
      runner_.set_up(arm_);
      say(kReady);
      for (const std::size_t task : tasks) say(journal_line(run_cell(runner_, plan_.task(task), limits_)));
    });
    const Answer ready = next_answer(child, limits_.wall_s, limits_.memory_mb);
    if (!ready.given) {
      for (const std::size_t task : tasks) finish(task, failed("in its set-up: " + ready.failure), finished);
      tasks.clear();
    }
    while (!tasks.empty()) {
      const Answer answer = next_answer(child, limits_.wall_s + kPatience_s, std::numeric_limits<double>::infinity());
      CellResult result =
          answer.given ? parse_journal_line(answer.line, "a cell") : failed("its process " + answer.failure);
      finish(tasks.front(), std::move(result), finished);
      tasks.erase(tasks.begin());
      if (!answer.given) break;  // another process goes on with the rest
    }
  }

 private:
  static CellResult failed(std::string failure) {
    CellResult result;
    result.failure = std::move(failure);
    return result;
  }
  void finish(std::size_t task, CellResult result, const std::function<void(const CellResult&)>& finished) const {
    result.number = task * plan_.arms() + arm_;
    result.input = runner_.input(plan_.task(task)) + result.input;
    finished(result);
  }

  CellRunner& runner_;
  const CellPlan& plan_;
  std::size_t arm_;
  const CellLimits& limits_;
};

}  // namespace

void run_cells(CellRunner& runner, const CellPlan& plan, std::size_t arm, const std::vector<std::size_t>& tasks,
               const CellLimits& limits, const std::function<void(const CellResult&)>& finished) {
  if (tasks.empty()) return;
  runner.enter(plan.task(tasks.front()));
  std::vector<std::size_t> left = tasks;
  while (!left.empty()) ArmProcess(runner, plan, arm, limits).run(left, finished);
}

}  // namespace opal::ab
