#include "cli/map/map_fleet.hpp"
#include "cli/options/exit_code.hpp"
#include "session/session.hpp"

#include "map/check/map_diff.hpp"

#include <iostream>

namespace opal::cli {
namespace {

struct DiffOptions {
  std::string before, after;
  bool summary = false;
};

int diff(const DiffOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  const auto before = session::load_map(registry, options.before), after = session::load_map(registry, options.after);
  const MapDiff diff = map_diff(*before, *after);
  const std::vector<std::string> sentences = diff.sentences();
  const std::size_t shown = options.summary ? sentences.size() - diff.changes.size() : sentences.size();
  for (std::size_t k = 0; k < shown; ++k) std::cout << sentences[k] << '\n';
  if (diff.empty()) std::cout << "no difference\n";
  return diff.empty() ? kDone : kNo;
}

}  // namespace

void add_map_diff(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* verb = map.add_subcommand("diff", "what was added, removed, moved or re-typed from one map to another");
  verb->add_option("BEFORE", options->before, "map document, a source to import, or store:BUILDING[@VERSION]")
      ->required();
  verb->add_option("AFTER", options->after, "the same")->required();
  verb->add_flag("--summary", options->summary, "counts only");
  verb->callback([options, &exit_code] { exit_code = diff(*options); });
}

}  // namespace opal::cli
