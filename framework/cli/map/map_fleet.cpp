#include "cli/map/map_fleet.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"

#include "session/session.hpp"
#include "session/stored_maps.hpp"

#include "map/map_file.hpp"

#include <algorithm>
#include <iostream>

namespace opal::cli {
namespace {

struct PushOptions {
  std::string map;
  MapPush push;
};

int push(const PushOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  const auto store = session::map_store(registry);
  const auto map = session::load_map(registry, options.map);
  try {
    const StoredVersion version = store->push(*map, options.push);
    std::cout << "pushed: " << session::described(version) << "; " << version.features << " features, to "
              << store->where() << '\n';
    return kDone;
  } catch (const StoreConflict& conflict) {
    std::cerr << "opal: " << conflict.what() << '\n';
    return kNo;
  }
}

void add_push(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<PushOptions>();
  CLI::App* verb = map.add_subcommand("push", "put a map into the map store, as the newest version of a building");
  verb->add_option("MAP", options->map, "map document, a source to import, or store:BUILDING[@VERSION]")->required();
  verb->add_option("--building", options->push.building, "whose map it is")->required();
  verb->add_option("--message", options->push.message, "what is new, for those who list versions");
  verb->add_option("--expect", options->push.expected_version,
                   "push only if this is the newest version so far; 0: the building is new to the store")
      ->check(zero_or_more());
  verb->callback([options, &exit_code] { exit_code = push(*options); });
}

struct PullOptions {
  StoreSource source;
  std::string out;
};

int pull(const PullOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  const auto store = session::map_store(registry);
  const StoredMap stored = store->pull(options.source.building, options.source.version);
  const auto map = SemanticMap::parse(stored.document, text_of(options.source));
  write_map(*map, options.out);
  std::cout << "pulled: " << session::described(stored.version) << "; " << stored.version.features << " features, from "
            << store->where() << "\nwritten: " << options.out << '\n';
  return kDone;
}

void add_pull(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<PullOptions>();
  CLI::App* verb = map.add_subcommand("pull", "write a map of the map store into a file");
  verb->add_option("--building", options->source.building, "whose map")->required();
  verb->add_option("--version", options->source.version, "which version; the newest if it is not given")
      ->check(above_zero());
  verb->add_option("-o,--out", options->out, "map document to write (.jsonld)")->required();
  verb->callback([options, &exit_code] { exit_code = pull(*options); });
}

/// Columns as wide as their longest text; the last one free.
void print_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      line += row[k];
      if (k + 1 < row.size()) line.append(widths[k] - row[k].size() + 2, ' ');
    }
    std::cout << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
  }
}

/// A message of several lines stays in its row.
std::string first_line(const std::string& text) {
  const std::size_t end = text.find_first_of("\r\n");
  return end == std::string::npos ? text : text.substr(0, end) + " ...";
}

int list(const std::string& building) {
  const PluginRegistry registry = session::load_plugins();
  const auto store = session::map_store(registry);
  const std::vector<StoredVersion> versions = store->list(building);
  if (versions.empty()) {
    std::cout << store->where() << ": no map" << (building.empty() ? "" : " of building '" + building + "'") << '\n';
    return kNo;
  }
  std::vector<std::vector<std::string>> rows{
      {"building", "version", "pushed at", "by", "objects", "features", "patterns", "message"}};
  for (const StoredVersion& version : versions)
    rows.push_back({version.building, std::to_string(version.version), version.pushed_at, version.pushed_by,
                    std::to_string(version.objects), std::to_string(version.features), std::to_string(version.patterns),
                    first_line(version.message)});
  print_table(rows);
  return kDone;
}

void add_list(CLI::App& map, int& exit_code) {
  auto building = std::make_shared<std::string>();
  CLI::App* verb =
      map.add_subcommand("list", "the maps in the map store: buildings, versions, who pushed them and when");
  verb->add_option("--building", *building, "only this one");
  verb->callback([building, &exit_code] { exit_code = list(*building); });
}

}  // namespace

void add_map_fleet(CLI::App& map, int& exit_code) {
  add_push(map, exit_code);
  add_pull(map, exit_code);
  add_list(map, exit_code);
}

}  // namespace opal::cli
