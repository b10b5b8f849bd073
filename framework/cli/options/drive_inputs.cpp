#include "cli/options/drive_inputs.hpp"

#include "benchmark/runs/progress_bar.hpp"
#include "benchmark/runs/recorded_log.hpp"
#include "common/phrases.hpp"
#include "fleet/fleet_evidence.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include <opal/sensing/replay.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <iostream>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;

/// One drive per window of a log.
std::vector<DriveEvidence> watched(const LogRunOptions& options, const PluginRegistry& registry,
                                   const std::string& log_file, const std::shared_ptr<const SemanticMap>& map) {
  LogRunOptions run = options;
  run.log = log_file;
  Deployment deployment = run.deployment();
  const benchmark::RecordedLog log = benchmark::read_recorded_log(registry, log_file, deployment, run.log_words);
  deployment.lasers = run.lasers_of(log.records, deployment.lasers);
  const LocalizerParts parts = build_parts(deployment, registry, map);
  std::vector<DriveEvidence> drives;
  benchmark::ProgressBar bar;
  for (const Query& window : run.windows()) {
    ReplayOptions cut;
    cut.from_s = window.start_s;
    cut.to_s = window.end_s;
    Replay replay(log.records, deployment.lasers, cut);
    const std::string name = fs::path(log_file).filename().string();
    const std::string called = run.queries.empty() ? name : name + " " + window.id;
    drives.push_back(observed_drive(parts, replay, called, [&](double share) { bar.show(share, called); }));
    bar.clear();
    const DriveEvidence& drive = drives.back();
    fmt::print("{}: learned along {:.0f} m in {}; {:.0f} m left out\n", drive.drive, drive.learned_m,
               count_of(drive.visits.size(), "visit"), drive.left_out_m);
  }
  return drives;
}

std::vector<DriveEvidence> pushed_by_robots(const PluginRegistry& registry, const session::VersionedMap& map) {
  if (!map.version)
    throw ConfigError("LOG is missing: without a recorded log or evidence (.json), MAP must be store:BUILDING");
  const auto store = session::map_store(registry);
  FleetEvidence evidence = evidence_in(*store, *map.version, map.map->name());
  for (const std::string& refusal : evidence.refused) std::cerr << "opal: left out: " << refusal << '\n';
  fmt::print("{} drives about {}, from {}\n", evidence.drives.size(), text_of(*map.version), store->where());
  return std::move(evidence.drives);
}

bool is_evidence(const std::string& file) { return fs::path(file).extension() == ".json"; }

}  // namespace

void DriveInputs::add_to(CLI::App& verb) {
  verb.add_option("MAP", run.map, "map document, or a source to import")->required();
  verb.add_option("LOG", files,
                  "recorded logs, and evidence of drives (.json); none: what robots have pushed about store:BUILDING");
  run.config = "default";
  verb.add_option("--config", run.config, "deployment document, or the name of one that ships")->capture_default_str();
  verb.add_option("--info", run.info, "SITE.info.json that describes the laser; overrides the deployment's");
  add_log_words(verb, run.log_words);
  verb.add_option("--queries", run.queries, "SITE.queries.json: each window is a drive of its own");
  run.overlays.add_to(verb, ", beside those of the deployment");
}

std::vector<DriveEvidence> DriveInputs::drives(const PluginRegistry& registry,
                                               const session::VersionedMap& loaded) const {
  if (files.empty()) return pushed_by_robots(registry, loaded);
  const auto& map = loaded.map;
  std::vector<DriveEvidence> drives;
  for (const std::string& file : files) {
    if (is_evidence(file)) {
      const nlohmann::json document = read_json(file);
      for (const nlohmann::json& drive : document.is_array() ? document : nlohmann::json::array({document}))
        drives.push_back(drive_evidence_from(drive, file));
      continue;
    }
    for (DriveEvidence& drive : watched(run, registry, file, map)) drives.push_back(std::move(drive));
  }
  for (const DriveEvidence& drive : drives)
    if (drive.map != map->name())
      throw ConfigError(drive.drive + ": tells of the map \"" + drive.map + "\", expected \"" + map->name() + "\"");
  return drives;
}

}  // namespace opal::cli
