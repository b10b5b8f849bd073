#include "cli/map/map_import.hpp"
#include "cli/map/map_derive.hpp"
#include "cli/map/map_stack.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/picture_files.hpp"

#include "common/phrases.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include "common/text_file.hpp"
#include "map/map_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace opal::cli {
namespace {

struct ImportOptions {
  std::string source, out, report, config, storey;
  PictureFiles picture;
  std::optional<double> z_m;
  std::vector<std::string> words, detectors;
  double thicken_m = 0;
  bool all = false;
  StackVerbOptions stack;
};

/// Those that --config trusts.
PluginRegistry plugins_for(const ImportOptions& options) {
  return options.config.empty() ? session::load_plugins()
                                : session::load_plugins(read_deployment(session::config_file(options.config)));
}

/// All that was said about options: by the deployment first, then on the command line.
nlohmann::json options_for(const RegisteredType& importer, const PluginRegistry& registry,
                           const ImportOptions& options) {
  nlohmann::json chosen = nlohmann::json::object();
  if (!options.config.empty())
    chosen = importer_options(read_deployment(session::config_file(options.config)), registry, importer.info.name);
  chosen.merge_patch(parse_options(importer.info.name, importer.options, options.words));
  if (!options.storey.empty()) chosen["storey"] = options.storey;
  if (options.z_m) chosen["z_m"] = *options.z_m;
  if (options.thicken_m > 0) chosen["thicken_m"] = options.thicken_m;
  return chosen;
}

std::string text_of(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + '\n';
  return text;
}

void write_report(const MapImport& imported, const std::string& path) {
  const bool is_json = std::filesystem::path(path).extension() == ".json";
  write_text(path, is_json ? import_report(imported).dump(1) + '\n' : text_of(imported.report));
}

void write_report(const ImportedStoreys& imported, const std::string& path) {
  nlohmann::ordered_json by_storey = nlohmann::ordered_json::object();
  std::string text;
  for (std::size_t k = 0; k < imported.parts.size(); ++k) {
    by_storey[imported.parts[k].id] = import_report(imported.imports[k]);
    text += imported.parts[k].id + ":\n" + text_of(imported.imports[k].report);
  }
  write_text(path, std::filesystem::path(path).extension() == ".json" ? by_storey.dump(1) + '\n' : text);
}

/// What is missing or doubtful on each storey; the whole reports are for --report.
std::string shortfalls_of(const ImportedStoreys& imported) {
  std::string text;
  for (std::size_t k = 0; k < imported.parts.size(); ++k)
    for (const std::string& sentence : imported.imports[k].report)
      if (sentence.starts_with("left out") || sentence.starts_with("doubtful"))
        text += imported.parts[k].id + ": " + sentence + '\n';
  return text;
}

/// Every storey, a sheet each.
int import_all(const ImportOptions& options, const PluginRegistry& registry, const nlohmann::json& chosen) {
  ImportedStoreys imported = import_storeys(registry, options.source, chosen, options.stack);
  std::cout << text_of(imported.left_out) << shortfalls_of(imported);
  MapImport all;
  all.map = finished(imported.stacked, options.stack);
  for (const std::string& detector : options.detectors) all.map = derived_by(registry, *all.map, detector, {}, {}).map;
  write_map(*all.map, options.out);
  std::cout << stacked_sentence(options.out, *all.map) << '\n';
  if (!options.report.empty()) write_report(imported, options.report);
  options.picture.write_with_coordinates(all.map);
  return kDone;
}

int import(const ImportOptions& options) {
  const PluginRegistry registry = plugins_for(options);
  const RegisteredType& importer = session::importer_of(registry, options.source);
  const nlohmann::json chosen = options_for(importer, registry, options);
  if (options.all) return import_all(options, registry, chosen);
  MapImport imported = session::import_map(registry, options.source, chosen);
  for (const std::string& detector : options.detectors)
    imported.map = derived_by(registry, *imported.map, detector, {}, {}).map;
  write_map(*imported.map, options.out);
  std::cout << text_of(imported.report) << "written: " << options.out << '\n';
  if (!options.report.empty()) write_report(imported, options.report);
  options.picture.write_with_coordinates(imported.map);
  return kDone;
}

/// A plan has levels without heights.
void print(const Storey& storey, bool has_heights) {
  fmt::print("{:<24}  ", "'" + storey.name + "'");
  if (has_heights) fmt::print("level {:8.3f} m  cut {:8.3f} m  ", storey.elevation_m, storey.height_m);
  const auto text_of = [](const auto& gives) { return fmt::format("{} {}", gives.second, gives.first); };
  fmt::print("{}\n", storey.gives.empty() ? "nothing" : listed_by(storey.gives, text_of));
}

int storeys(const std::string& source, const ImportOptions& options) {
  const PluginRegistry registry = plugins_for(options);
  const RegisteredType& type = session::importer_of(registry, source);
  const auto importer = registry.make<MapImporter>(type.info.name, options_for(type, registry, options));
  const std::vector<Storey> levels = importer->storeys(source);
  if (levels.empty()) std::cout << source << ": has no storeys\n";
  const bool has_heights =
      std::ranges::any_of(levels, [](const Storey& level) { return level.elevation_m != 0 || level.height_m != 0; });
  for (const Storey& level : levels) print(level, has_heights);
  return levels.empty() ? kNo : kDone;
}

void add_choices(CLI::App& verb, ImportOptions& options) {
  verb.add_option("--set", options.words,
                  "an option of the importer, NAME=VALUE or NAME.KEY=TEXT; `opal plugins` lists them; may be repeated")
      ->allow_extra_args(false);
  verb.add_option("--config", options.config, "a deployment whose importers give options (.jsonld)");
}

}  // namespace

void add_map_import(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* verb = map.add_subcommand("import", "make a semantic map of a grid, a building model or a drawing");
  verb->add_option("SOURCE", options->source, "what to import")->required();
  verb->add_option("-o,--out", options->out, "map document to write (.jsonld)")->required();
  options->picture.add_to(*verb);
  verb->add_option("--report", options->report,
                   "also write the report: thing by thing as JSON (.json), or its sentences");
  CLI::Option* storey =
      verb->add_option("--storey", options->storey, "name of the storey to import (`opal map storeys`)");
  verb->add_option("--z", options->z_m, "height of the cut in the building's coordinates [m], instead of a storey")
      ->excludes(storey);
  CLI::Option* all = verb->add_flag("--all", options->all, "every storey of the source, a sheet each in one map")
                         ->excludes(storey)
                         ->excludes(verb->get_option("--z"));
  verb->add_option("--without", options->stack.without,
                   "of --all: name of a storey to leave out, as a roof; may be repeated")
      ->allow_extra_args(false)
      ->needs(all);
  options->stack.add_to(*verb);
  add_choices(*verb, *options);
  verb->add_option("--derive", options->detectors,
                   "add the features that this detector would find (`opal map derive`); may be repeated")
      ->allow_extra_args(false);
  verb->add_option("--thicken", options->thicken_m,
                   "for experiments: make walls of a grid so much thicker first, and its cells 0.1 m [m]");
  verb->callback([options, &exit_code] { exit_code = import(*options); });
}

void add_map_storeys(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* verb =
      map.add_subcommand("storeys", "the levels of a building model, and what an import of each would give");
  verb->add_option("FILE", options->source, "building model")->required();
  add_choices(*verb, *options);
  verb->callback([options, &exit_code] { exit_code = storeys(options->source, *options); });
}

}  // namespace opal::cli
