#include "cli/map/map_review.hpp"

#include "cli/options/drive_inputs.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "common/digest/sha256.hpp"
#include "common/text_file.hpp"
#include "review/review_server.hpp"
#include "session/session.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <condition_variable>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <set>

namespace {

namespace fs = std::filesystem;

struct ReviewOptions {
  DriveInputs inputs;
  std::string out, decisions, html;
  double least_probability = opal::kLeastProbability;
  int port = opal::ReviewServer::kUsualPort;
};

/// The same for the same set of drives, whatever their order.
std::string digest_of(const std::vector<opal::DriveEvidence>& drives) {
  std::set<std::string> documents;
  for (const opal::DriveEvidence& drive : drives) documents.insert(opal::to_json(drive).dump());
  opal::Sha256 digest;
  for (const std::string& document : documents) digest.add(document + '\n');
  return digest.finish();
}

opal::ReviewMatter matter_of(const ReviewOptions& options) {
  const opal::Deployment deployment = options.inputs.run.deployment();
  const opal::PluginRegistry registry = opal::session::load_plugins(deployment);
  opal::ReviewMatter matter;
  const opal::session::VersionedMap loaded = opal::session::load_versioned_map(registry, deployment);
  matter.map = loaded.map;
  const std::vector<opal::DriveEvidence> drives = options.inputs.drives(registry, loaded);
  matter.learned = opal::learned_from(*matter.map, drives);
  matter.sensor = deployment.lasers.front().id;
  matter.map_digest = opal::sha256_of(matter.map->to_json_ld().dump());
  matter.evidence_digest = digest_of(drives);
  matter.least_probability = options.least_probability;
  return matter;
}

/// Beside the overlay: "learned.jsonld" has "learned.decisions.json".
std::string decisions_beside(const std::string& overlay) {
  return fs::path(overlay).replace_extension(".decisions.json").string();
}

/// Goes on with the decisions of a file. @return what has changed since, which is also told on the screen.
std::vector<std::string> resumed(opal::Review& review, const std::string& file) {
  const std::vector<std::string> notes = review.resume(opal::decisions_from(opal::read_json(file), file), file);
  for (const std::string& note : notes) std::cout << note << '\n';
  return notes;
}

int make_overlay(const opal::Review& review, const std::string& out) {
  opal::write_text(out, review.overlay().dump(1) + '\n');
  std::cout << review.count() << "; written: " << out << '\n';
  return kDone;
}

int make_page(const opal::Review& review, const std::vector<std::string>& notes, const std::string& html) {
  opal::write_text(html, opal::review_page(review, notes, std::nullopt));
  std::cout << review.count() << "; written: " << html << '\n';
  return kDone;
}

int serve(opal::Review& review, const ReviewOptions& options) {
  const opal::ReviewFiles files{decisions_beside(options.out), options.out};
  std::vector<std::string> notes;
  if (fs::exists(files.decisions)) notes = resumed(review, files.decisions);
  const StopSignals signals;  // before the server's threads
  {
    const opal::ReviewServer server(review, notes, files, options.port);
    std::cout << review.count() << "; decisions go to " << files.decisions << "\nreview at " << server.url()
              << " (on this machine only; Ctrl-C ends it)" << std::endl;
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any().wait(lock, signals.token(), [] { return false; });
  }
  std::cout << review.count() << '\n';
  if (review.decisions().all.empty()) return kDone;  // nobody has said anything: what is there stays
  save(review, files);
  std::cout << "written: " << files.decisions << ", " << files.overlay << '\n';
  return kDone;
}

int review(const ReviewOptions& options) {
  if (options.out.empty() && options.html.empty())
    throw CLI::ValidationError("-o is missing, expected an overlay to write (.jsonld), or --html with a page to write");
  opal::Review review(matter_of(options));
  std::vector<std::string> notes;
  if (!options.decisions.empty()) notes = resumed(review, options.decisions);
  if (!options.html.empty()) make_page(review, notes, options.html);
  if (options.out.empty()) return kDone;
  return options.decisions.empty() && options.html.empty() ? serve(review, options) : make_overlay(review, options.out);
}

}  // namespace

void add_map_review(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<ReviewOptions>();
  CLI::App* verb = map.add_subcommand("review", "look at what drives say of a map, accept or refuse it; an overlay");
  options->inputs.add_to(*verb);
  verb->add_option("-o,--out", options->out, "overlay of what is accepted (.jsonld); decisions are kept beside it");
  verb->add_option("--html", options->html, "write a page that stands alone, instead of serving one");
  verb->add_option(
      "--decisions", options->decisions,
      "decisions of such a page: makes the overlay of them, without a page; with --html, goes on with them");
  verb->add_option("--port", options->port, "of the page on this machine; 0: any free one")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  verb->add_option("--least", options->least_probability, "proposals that are less probable are shown as doubtful")
      ->check(CLI::Range(0.5, 1.0))
      ->capture_default_str();
  verb->callback([options, &exit_code] { exit_code = review(*options); });
}
