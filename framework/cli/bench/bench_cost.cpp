#include "cli/bench/bench_cost.hpp"

#include <opal/common/quantile.hpp>

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <algorithm>
#include <numeric>

namespace opal::cli {
namespace {

double peak_rss_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace

double allocated_mb() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) / (1 << 20);
}

nlohmann::ordered_json summarize(const benchmark::RunRecord& all, const BenchCost& cost) {
  std::vector<double> cpu = all.update_cpu_ms;
  std::sort(cpu.begin(), cpu.end());
  const double n = std::max<double>(1, static_cast<double>(cpu.size()));
  const auto mean_ms = [&](double sum_s) { return 1e3 * sum_s / n; };
  return {{"queries", cost.queries},
          {"updates", cpu.size()},
          {"cpu_ms_mean", std::accumulate(cpu.begin(), cpu.end(), 0.0) / n},
          {"cpu_ms_median", quantile_of(cpu, 0.5).value_or(0)},
          {"cpu_ms_p99", quantile_of(cpu, 0.99).value_or(0)},
          {"cpu_ms_max", cpu.empty() ? 0 : cpu.back()},
          {"peak_rss_mb", peak_rss_mb()},
          {"localizer_mb", cost.localizer_mb},
          {"import_s", cost.import_s},
          {"hypotheses_mean", all.hypotheses / n},
          {"stage_ms_mean",
           {{"sensor", mean_ms(all.stages.sensor_s)},
            {"detect", mean_ms(all.stages.detect_s)},
            {"local_map", mean_ms(all.stages.local_map_s)},
            {"track", mean_ms(all.stages.track_s)},
            {"generate", mean_ms(all.stages.generate_s)},
            {"search", mean_ms(all.stages.search_s)},
            {"retrospect", mean_ms(all.stages.retrospect_s)},
            {"grow", mean_ms(all.stages.grow_s)},
            {"status", mean_ms(all.stages.status_s)}}}};
}

/// The costs for people.
std::string cost_text(const nlohmann::ordered_json& summary) {
  return fmt::format("CPU per update {:.2f} ms (median), 99 % below {:.1f} ms; memory {:.0f} MB; map import {:.1f} s\n",
                     summary["cpu_ms_median"].get<double>(), summary["cpu_ms_p99"].get<double>(),
                     summary["peak_rss_mb"].get<double>(), summary["import_s"].get<double>());
}

}  // namespace opal::cli
