#include "benchmark/experiments/faults/fault_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace opal::experiments {
namespace {

constexpr double kLong_s = 1;  // localized elsewhere for longer is a false promise

std::vector<FaultRun> of_trouble(const std::vector<FaultRun>& runs, const std::string& name) {
  std::vector<FaultRun> chosen;
  std::ranges::copy_if(runs, std::back_inserter(chosen), [&](const FaultRun& run) { return run.trouble == name; });
  return chosen;
}

template <class Test>
std::string count_of(const std::vector<FaultRun>& runs, Test test) {
  return std::to_string(std::ranges::count_if(runs, test));
}

/// Of the drives that were localized when the fault began; those that never were again count as infinite.
std::string recovery_of(std::vector<FaultRun> runs, double share) {
  std::erase_if(runs, [](const FaultRun& run) { return !run.localized_before; });
  if (runs.empty()) return "";
  std::vector<double> after_s;
  for (const FaultRun& run : runs)
    after_s.push_back(run.recovered_after_s.value_or(std::numeric_limits<double>::infinity()));
  std::ranges::sort(after_s);
  const auto within = static_cast<std::size_t>(std::ceil(share * static_cast<double>(after_s.size())));
  const double at = after_s[within - 1];
  return std::isfinite(at) ? fmt::format("{:.1f}", at) : "never";
}

}  // namespace

Table fault_table(const std::vector<FaultRun>& runs) {
  Table table;
  table.columns = {{"fault", "", false},        {"drives"},
                   {"localized before"},        {"localized elsewhere"},
                   {"... for longer than 1 s"}, {"recovered after, median", "s"},
                   {"95 % within", "s"},        {"named"}};
  for (const Trouble& trouble : all_troubles()) {
    const std::vector<FaultRun> these = of_trouble(runs, trouble.name);
    if (these.empty()) continue;
    table.rows.push_back(
        {trouble.name, std::to_string(these.size()),
         count_of(these, [](const FaultRun& run) { return run.localized_before; }),
         count_of(these, [](const FaultRun& run) { return run.localized.wrong_from_s.has_value(); }),
         count_of(these, [](const FaultRun& run) { return run.localized.longest_wrong_s > kLong_s; }),
         recovery_of(these, 0.5), recovery_of(these, 0.95),
         trouble.named.empty() ? "" : count_of(these, [](const FaultRun& run) { return run.is_named; })});
  }
  return table;
}

Table fault_rows(const std::vector<FaultRun>& runs) {
  Table table;
  table.columns = {{"fault", "", false},  {"seed"},           {"building", "", false}, {"localized_before"},
                   {"recovered_after_s"}, {"wrong_s"},        {"longest_wrong_s"},     {"named"},
                   {"answers"},           {"worst_latency_s"}};
  for (const FaultRun& run : runs)
    table.rows.push_back({run.trouble, std::to_string(run.seed), run.building, run.localized_before ? "1" : "0",
                          run.recovered_after_s ? fmt::format("{:.2f}", *run.recovered_after_s) : "",
                          fmt::format("{:.2f}", run.localized.wrong_s),
                          fmt::format("{:.2f}", run.localized.longest_wrong_s), run.is_named ? "1" : "0",
                          std::to_string(run.answers), fmt::format("{:.3f}", run.worst_latency_s)});
  return table;
}

}  // namespace opal::experiments
