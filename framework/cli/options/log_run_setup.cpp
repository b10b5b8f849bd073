#include "cli/options/log_run_setup.hpp"

#include "sensing/log_check.hpp"
#include "session/session.hpp"

#include <fmt/format.h>

#include <utility>

namespace opal::cli {
namespace {

void take_log(const LogRunOptions& options, LogRunSetup& setup) {
  std::vector<LaserModel>& lasers = setup.deployment.lasers;
  setup.log = benchmark::read_recorded_log(setup.plugins, options.log, setup.deployment, options.log_words);
  setup.silent_lasers = silent_lasers(setup.log.records, lasers);
  lasers = options.lasers_of(setup.log.records, lasers);
  setup.mount_doubt = options.mount_doubt(setup.log.records, setup.deployment);
}

}  // namespace

LogRunSetup set_up(const LogRunOptions& options, Deployment deployment, const std::optional<MapDamage>& damage) {
  LogRunSetup setup;
  setup.plugins = session::load_plugins(deployment);
  setup.deployment = std::move(deployment);
  setup.map = session::load_map(setup.plugins, setup.deployment);
  if (damage) setup.map = damaged_map(*setup.map, *damage);
  take_log(options, setup);
  setup.windows = options.windows();
  if (!options.queries.empty()) benchmark::expect_scans(setup.windows, setup.log, options.queries);
  if (!options.truth.empty()) setup.truth = GroundTruth::read(options.truth);
  if (setup.truth) benchmark::expect_overlap(*setup.truth, setup.log, options.truth);
  setup.parts = build_parts(setup.deployment, setup.plugins, setup.map);
  return setup;
}

void LogRunSetup::tell_doubts() const {
  if (!mount_doubt.empty()) fmt::print("sensor: {}\n", mount_doubt);
  for (const std::string& frame : silent_lasers) fmt::print("sensor: laser {}: no scan in the log\n", frame);
  for (const auto& [cause, count] : log.defects) fmt::print("log: {}: {} times\n", cause, count);
  for (const std::string& doubt : benchmark::doubts_of(log, deployment.lasers.front())) fmt::print("log: {}\n", doubt);
}

}  // namespace opal::cli
