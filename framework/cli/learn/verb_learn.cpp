#include "benchmark/runs/recorded_log.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/log_run_options.hpp"
#include "cli/options/verbs.hpp"
#include "common/text_file.hpp"
#include "drawing/drawing.hpp"
#include "learning/learned_overlay.hpp"
#include "session/session.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include <opal/deployment/deployment.hpp>
#include <opal/sensing/replay.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

namespace {

namespace fs = std::filesystem;

struct LearnOptions {
  LogRunOptions run;
  std::vector<std::string> inputs;
  std::string out, evidence, csv, png, svg;
  double least_probability = 0.9;
};

/// One drive per window of a log.
std::vector<opal::DriveEvidence> watched(const LearnOptions& options, const opal::PluginRegistry& registry,
                                         const std::string& log_file,
                                         const std::shared_ptr<const opal::SemanticMap>& map) {
  LogRunOptions run = options.run;
  run.log = log_file;
  opal::Deployment deployment = run.deployment();
  const RecordedLog log = read_recorded_log(registry, log_file, deployment, run.log_words);
  deployment.lasers = run.lasers_of(log.records, deployment.lasers);
  const opal::LocalizerParts parts = opal::build_parts(deployment, registry, map);
  std::vector<opal::DriveEvidence> drives;
  for (const opal::Query& window : run.windows()) {
    opal::ReplayOptions cut;
    cut.from_s = window.start_s;
    cut.to_s = window.end_s;
    opal::Replay replay(log.records, deployment.lasers, cut);
    opal::DriveObserver observer(parts);
    while (const auto sample = replay.next()) observer.update(*sample);
    const std::string name = fs::path(log_file).filename().string();
    drives.push_back(observer.finish(run.queries.empty() ? name : name + " " + window.id));
    const opal::DriveEvidence& drive = drives.back();
    std::printf("%s: learned along %.0f m in %zu visits; %.0f m left out\n", drive.drive.c_str(), drive.learned_m,
                drive.visits.size(), drive.left_out_m);
  }
  return drives;
}

bool is_evidence(const std::string& file) { return fs::path(file).extension() == ".json"; }

std::vector<opal::DriveEvidence> evidence_of(const LearnOptions& options, const opal::PluginRegistry& registry,
                                             const std::shared_ptr<const opal::SemanticMap>& map) {
  std::vector<opal::DriveEvidence> drives;
  for (const std::string& file : options.inputs) {
    if (is_evidence(file)) {
      const nlohmann::json document = opal::read_json(file);
      for (const nlohmann::json& drive : document.is_array() ? document : nlohmann::json::array({document}))
        drives.push_back(opal::drive_evidence_from(drive, file));
      continue;
    }
    for (opal::DriveEvidence& drive : watched(options, registry, file, map)) drives.push_back(std::move(drive));
  }
  for (const opal::DriveEvidence& drive : drives)
    if (drive.map != map->name())
      throw opal::ConfigError(drive.drive + ": tells of the map \"" + drive.map + "\", expected \"" + map->name() +
                              "\"");
  return drives;
}

void write_evidence(const std::vector<opal::DriveEvidence>& drives, const std::string& file) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const opal::DriveEvidence& drive : drives) all.push_back(opal::to_json(drive));
  opal::write_text(file, all.dump(1) + '\n');
}

void write_csv(const opal::Learned& learned, const std::string& file) {
  std::string csv = "object,type,change,probability,moved_x_m,moved_y_m,sigma_m,visits_for,visits_against,drives\n";
  for (const opal::Proposal& p : learned.proposals) {
    char line[256];
    std::snprintf(line, sizeof line, ",%s,%.4f,%.3f,%.3f,%.3f,%d,%d,", name_of(p.change), p.probability, p.moved.x(),
                  p.moved.y(), p.sigma_m, p.visits_for, p.visits_against);
    csv += '"' + p.id + "\"," + p.type + line + std::to_string(p.drives.size()) + '\n';
  }
  opal::write_text(file, csv);
}

void draw(const std::shared_ptr<const opal::SemanticMap>& map, const opal::Learned& learned,
          const LearnOptions& options) {
  opal::DrawingScene scene;
  scene.title = map->name() + ": what drives have taught";
  scene.map = map;
  for (const opal::Proposal& proposal : learned.proposals) {
    if (proposal.change == opal::Change::added) scene.unmapped.push_back(proposal.face);
    for (const opal::MapFeature& feature : map->features()) {
      if (map->object(feature.object).id != proposal.id) continue;
      const auto* face = std::get_if<opal::Segment>(&feature.geometry);
      if (proposal.change == opal::Change::gone && face) scene.contradictions.push_back({face->begin, face->end});
      if (proposal.change == opal::Change::moved)
        scene.local_features.push_back(
            {transformed(opal::Pose2(proposal.moved, 0), feature.geometry), opal::DrawingScene::Perception::matched});
    }
  }
  if (!options.svg.empty()) opal::write_svg(scene, options.svg);
  if (!options.png.empty()) opal::write_png(scene, options.png);
}

void print(const opal::Learned& learned, double least_probability) {
  for (const opal::Proposal& proposal : learned.proposals)
    std::printf("%s %s %s: %s\n", proposal.probability >= least_probability ? " " : "?", name_of(proposal.change),
                proposal.id.c_str(), sentence_of(proposal).c_str());
  std::printf("%zu objects stand where the map says; of %zu nothing is known\n", learned.sound, learned.unseen);
}

int learn(LearnOptions options) {
  if (options.run.config.empty()) options.run.config = "default";
  const opal::PluginRegistry registry = load_plugins();
  const opal::Deployment deployment = options.run.deployment();
  const auto map = load_map(registry, deployment);
  const std::vector<opal::DriveEvidence> drives = evidence_of(options, registry, map);
  const opal::Learned learned = opal::learned_from(*map, drives);
  print(learned, options.least_probability);
  const std::string sensor = deployment.lasers.front().id;
  opal::write_text(options.out, opal::overlay_of(*map, learned, sensor, options.least_probability).dump(1) + '\n');
  std::cout << "written: " << options.out << '\n';
  if (!options.evidence.empty()) write_evidence(drives, options.evidence);
  if (!options.csv.empty()) write_csv(learned, options.csv);
  draw(map, learned, options);
  const bool any = std::any_of(drives.begin(), drives.end(), [](const auto& drive) { return !drive.visits.empty(); });
  return any ? kDone : kNo;
}

}  // namespace

void opal::add_learn_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<LearnOptions>();
  CLI::App* verb =
      app.add_subcommand("learn", "the building as built: what drives say that the map has wrong, as an overlay");
  verb->add_option("MAP", options->run.map, "map document, or a source to import")->required();
  verb->add_option("LOG", options->inputs, "recorded logs, and evidence of drives (.json)")->required();
  verb->add_option("-o,--out", options->out, "overlay to write (.jsonld)")->required();
  verb->add_option("--config", options->run.config, "deployment document, or the name of one that ships; default");
  verb->add_option("--info", options->run.info, "SITE.info.json that describes the laser; overrides the deployment's");
  verb->add_option("--queries", options->run.queries, "SITE.queries.json: each window is a drive of its own");
  options->run.overlays.add_to(*verb, ", beside those of the deployment");
  verb->add_option("--least", options->least_probability, "changes that are less probable are told, not written")
      ->check(CLI::Range(0.5, 1.0))
      ->capture_default_str();
  verb->add_option("--evidence", options->evidence,
                   "also write what each drive says (.json), to be put together later");
  verb->add_option("--csv", options->csv, "also write a list of deviations by object");
  verb->add_option("--svg", options->svg, "also draw the map and what differs into this file");
  verb->add_option("--png", options->png, "the same as a PNG");
  verb->callback([options, &exit_code] { exit_code = learn(*options); });
}
