#include "cli/options/drive_inputs.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/picture_files.hpp"
#include "cli/options/verbs.hpp"
#include "common/text_file.hpp"
#include "fleet/fleet_evidence.hpp"
#include "learning/deviation_list.hpp"
#include "session/session.hpp"

#include <opal/deployment/deployment.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>

namespace opal::cli {
namespace {

struct LearnOptions {
  DriveInputs inputs;
  std::string out, evidence, csv;
  PictureFiles picture;
  bool is_pushed = false;
  double least_probability = kLeastProbability;
};

void write_evidence(const std::vector<DriveEvidence>& drives, const std::string& file) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const DriveEvidence& drive : drives) all.push_back(to_json(drive));
  write_text(file, all.dump(1) + '\n');
}

void draw(const std::shared_ptr<const SemanticMap>& map, const Learned& learned, const LearnOptions& options) {
  DrawingScene scene;
  scene.title = map->name() + ": what drives have taught";
  scene.map = map;
  scene.unmapped_words = "added: the map lacks it";
  scene.matched_words = "moved: where the drives see it";
  scene.contradiction_words = "gone: beams pass through it";
  for (const Proposal& proposal : learned.proposals) {
    if (proposal.change == Change::added) scene.unmapped.push_back(proposal.face);
    for (const MapFeature& feature : map->features()) {
      if (map->object(feature.object).id != proposal.id) continue;
      const auto* face = std::get_if<Segment>(&feature.geometry);
      if (proposal.change == Change::gone && face) scene.contradictions.push_back({face->begin, face->end});
      if (proposal.change == Change::moved)
        scene.local_features.push_back(
            {transformed(Pose2(proposal.moved, 0), feature.geometry), DrawingScene::Perception::matched});
    }
  }
  options.picture.write(scene);
}

void print(const Learned& learned, double least_probability) {
  for (const Proposal& proposal : learned.proposals)
    fmt::print("{} {} {}: {}\n", proposal.probability >= least_probability ? " " : "?", name_of(proposal.change),
               proposal.id, sentence_of(proposal));
  fmt::print("{} objects stand where the map says; of {} nothing is known\n", learned.sound, learned.unseen);
}

void write_overlay(const SemanticMap& map, const Learned& learned, const std::string& sensor,
                   const LearnOptions& options) {
  if (options.out.empty()) return;
  write_text(options.out, overlay_of(map, learned, sensor, options.least_probability).dump(1) + '\n');
  std::cout << "written: " << options.out << '\n';
}

/// What cannot be pushed is found out before hours of logs are played.
void expect_pushable(const LearnOptions& options, const Deployment& deployment) {
  if (options.out.empty() && !options.is_pushed)
    throw CLI::ValidationError("-o is missing, expected an overlay to write (.jsonld), or --push");
  const std::string objection = options.is_pushed ? objection_to_push(deployment) : "";
  if (!objection.empty()) throw CLI::ValidationError(objection);
}

/// @return whether the store has it. Otherwise it waits on this machine, for the next time.
bool push(const PluginRegistry& registry, const StoreSource& version, const std::vector<DriveEvidence>& drives) {
  const auto store = session::map_store(registry);
  const EvidenceOutbox outbox = EvidenceOutbox::usual();
  for (const DriveEvidence& drive : drives)
    if (!drive.visits.empty()) outbox.keep(store->where(), version, to_json(drive).dump());
  try {
    const SentEvidence sent = send_waiting(*store, outbox);
    fmt::print("pushed: {} drives, of which {} are new, to {}\n", sent.confirmed, sent.added, store->where());
    for (const std::string& refusal : sent.refused) std::cerr << "opal: not pushed: " << refusal << '\n';
    return sent.refused.empty();
  } catch (const StoreUnreachable& error) {
    std::cerr << "opal: not pushed: " << error.what() << "\nopal: the drives wait in " << outbox.folder().string()
              << "; the next opal learn --push sends them\n";
    return false;
  }
}

int learn(const LearnOptions& options) {
  const Deployment deployment = options.inputs.run.deployment();
  expect_pushable(options, deployment);
  const PluginRegistry registry = session::load_plugins(deployment);
  const session::VersionedMap loaded = session::load_versioned_map(registry, deployment);
  const auto& map = loaded.map;
  const bool has_drives = !options.inputs.files.empty();
  bool is_sent = !options.is_pushed || has_drives || push(registry, *loaded.version, {});
  const std::vector<DriveEvidence> drives = options.inputs.drives(registry, loaded);
  const Learned learned = learned_from(*map, drives);
  print(learned, options.least_probability);
  write_overlay(*map, learned, deployment.lasers.front().id, options);
  if (!options.evidence.empty()) write_evidence(drives, options.evidence);
  if (!options.csv.empty()) write_text(options.csv, deviation_csv(*map, learned));
  draw(map, learned, options);
  if (options.is_pushed && has_drives) is_sent = push(registry, *loaded.version, drives);
  const bool any = std::any_of(drives.begin(), drives.end(), [](const auto& drive) { return !drive.visits.empty(); });
  return any && is_sent ? kDone : kNo;
}

}  // namespace

void add_learn_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<LearnOptions>();
  CLI::App* verb =
      app.add_subcommand("learn", "the building as built: what drives say that the map has wrong, as an overlay");
  options->inputs.add_to(*verb);
  verb->add_option("-o,--out", options->out, "overlay to write (.jsonld)");
  verb->add_flag("--push", options->is_pushed,
                 "tell the map store what the drives say of store:BUILDING, for all robots together");
  verb->add_option("--least", options->least_probability, "changes that are less probable are told, not written")
      ->check(in_range(0.5, 1.0))
      ->capture_default_str();
  verb->add_option("--evidence", options->evidence,
                   "also write what each drive says (.json), to be put together later");
  verb->add_option("--csv", options->csv, "also write a list of deviations by object");
  options->picture.add_to(*verb, "also draw the map and what differs into this file");
  verb->callback([options, &exit_code] { exit_code = learn(*options); });
}

}  // namespace opal::cli
