#include "benchmark/experiments/buildings/building_runs.hpp"

#include "benchmark/experiments/kit/order_statistics.hpp"
#include "benchmark/experiments/kit/thesis_robot.hpp"

#include "common/stage_clock.hpp"
#include "map/map_file.hpp"

#include "simulation/drives/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace opal::experiments {
namespace {

double first_time_s(const ChallengeRun& run, bool (*holds)(const JudgedMoment&)) {
  const auto moment = std::ranges::find_if(run.moments, holds);
  return moment == run.moments.end() ? kNever : moment->time_s;
}

std::vector<simulation::Challenge> chosen(const simulation::SuiteBuilding& building,
                                          const std::vector<std::string>& ids) {
  std::vector<simulation::Challenge> all = challenges_in(building);
  if (!ids.empty())
    std::erase_if(all, [&](const auto& challenge) { return std::ranges::find(ids, challenge.id) == ids.end(); });
  return all;
}

void keep(const BuildingRuns& in, const simulation::Challenge& challenge, int seed,
          const simulation::Recording& recording, const std::string& folder) {
  const std::string name = fmt::format("{}_{}_{}", in.building.id, challenge.id, seed);
  const std::string prefix = (std::filesystem::path(folder) / name).string();
  simulation::write_recording(recording, prefix);
  write_map(*in.map, prefix + ".map.jsonld");
}

}  // namespace

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::localized: return "localized";
    case Outcome::unsure: return "unsure";
    case Outcome::unknown: return "unknown";
    case Outcome::wrong: break;
  }
  return "wrong";
}

Outcome outcome_of(const ChallengeRun& run) {
  if (run.false_rows > 0) return Outcome::wrong;
  if (!run.success) return Outcome::unknown;
  return run.localized_rows > 0 ? Outcome::localized : Outcome::unsure;
}

double localized_after_s(const ChallengeRun& run) {
  return first_time_s(run, [](const JudgedMoment& moment) { return moment.localized(); });
}

double wrong_after_s(const ChallengeRun& run) {
  return first_time_s(run, [](const JudgedMoment& moment) { return moment.localized() && !moment.right(); });
}

BuildingRuns run_building(const simulation::SuiteBuilding& building, const PluginRegistry& registry,
                          const BuildingsOptions& options) {
  const double start_s = thread_cpu_s();
  BuildingRuns done{building, generate_building(building.request).map, {}, 0};
  for (const simulation::Challenge& challenge : chosen(building, options.challenges))
    for (int seed = 1; seed <= options.seeds; ++seed) {
      const auto driven =
          drive(challenge, done.map, thesis_robot(), options.duration_s, static_cast<std::uint64_t>(seed));
      if (!options.recordings.empty()) keep(done, challenge, seed, driven.recording, options.recordings);
      for (const Contender& contender : options.contenders) {
        ChallengeRun run = run_challenge(contender, registry, done.map, driven);
        run.challenge = challenge.id;
        run.seed = static_cast<std::uint64_t>(seed);
        done.runs.push_back(std::move(run));
      }
    }
  done.cpu_s = thread_cpu_s() - start_s;
  return done;
}

}  // namespace opal::experiments
