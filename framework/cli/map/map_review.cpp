#include "cli/map/map_review.hpp"

#include "cli/options/drive_inputs.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "common/digest/sha256.hpp"
#include "common/text_file.hpp"
#include "review/review_server.hpp"
#include "session/session.hpp"

#include <opal/common/strict_json.hpp>

#include <condition_variable>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <set>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;

struct ReviewOptions {
  DriveInputs inputs;
  std::string out, decisions, html;
  double least_probability = kLeastProbability;
  int port = ReviewServer::kUsualPort;
};

/// The same for the same set of drives, whatever their order.
std::string digest_of(const std::vector<DriveEvidence>& drives) {
  std::set<std::string> documents;
  for (const DriveEvidence& drive : drives) documents.insert(to_json(drive).dump());
  Sha256 digest;
  for (const std::string& document : documents) digest.add(document + '\n');
  return digest.finish();
}

ReviewMatter matter_of(const ReviewOptions& options) {
  const Deployment deployment = options.inputs.run.deployment();
  const PluginRegistry registry = session::load_plugins(deployment);
  ReviewMatter matter;
  const session::VersionedMap loaded = session::load_versioned_map(registry, deployment);
  matter.map = loaded.map;
  const std::vector<DriveEvidence> drives = options.inputs.drives(registry, loaded);
  matter.learned = learned_from(*matter.map, drives);
  matter.sensor = deployment.lasers.front().id;
  matter.map_digest = sha256_of(matter.map->to_json_ld().dump());
  matter.evidence_digest = digest_of(drives);
  matter.least_probability = options.least_probability;
  return matter;
}

/// Beside the overlay: "learned.jsonld" has "learned.decisions.json".
std::string decisions_beside(const std::string& overlay) {
  return fs::path(overlay).replace_extension(".decisions.json").string();
}

/// Goes on with the decisions of a file. @return what has changed since, which is also told on the screen.
std::vector<std::string> resumed(Review& review, const std::string& file) {
  const std::vector<std::string> notes = review.resume(decisions_from(read_json(file), file), file);
  for (const std::string& note : notes) std::cout << note << '\n';
  return notes;
}

int make_overlay(const Review& review, const std::string& out) {
  write_text(out, review.overlay().dump(1) + '\n');
  std::cout << review.count() << "; written: " << out << '\n';
  return kDone;
}

int make_page(const Review& review, const std::vector<std::string>& notes, const std::string& html) {
  write_text(html, review_page(review, notes, std::nullopt));
  std::cout << review.count() << "; written: " << html << '\n';
  return kDone;
}

/// What was decided before: in the file that is named, else beside the overlay; empty: nothing.
std::string decided_before(const ReviewOptions& options) {
  if (!options.decisions.empty() || options.out.empty()) return options.decisions;
  const std::string beside = decisions_beside(options.out);
  return fs::exists(beside) ? beside : "";
}

int serve(Review& review, const std::vector<std::string>& notes, const ReviewOptions& options) {
  const ReviewFiles files{decisions_beside(options.out), options.out};
  const StopSignals signals;  // before the server's threads
  {
    const ReviewServer server(review, notes, files, options.port);
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
  Review review(matter_of(options));
  const std::string decisions = decided_before(options);
  std::vector<std::string> notes;
  if (!decisions.empty()) notes = resumed(review, decisions);
  if (!options.html.empty()) make_page(review, notes, options.html);
  if (options.out.empty()) return kDone;
  if (options.decisions.empty() && options.html.empty()) return serve(review, notes, options);
  return decisions.empty() ? kDone : make_overlay(review, options.out);  // nobody has decided: what is there stays
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
      ->check(in_range(0, 65535))
      ->capture_default_str();
  verb->add_option("--least", options->least_probability, "proposals that are less probable are shown as doubtful")
      ->check(in_range(0.5, 1.0))
      ->capture_default_str();
  verb->callback([options, &exit_code] { exit_code = review(*options); });
}

}  // namespace opal::cli
