#include "cli/map/map_stack.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/picture_files.hpp"

#include "session/session.hpp"

#include "common/phrases.hpp"
#include "deployment/store_source.hpp"
#include "map/map_file.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

namespace opal::cli {
namespace {

/// Levels nearer than this are two names of one storey: a raised floor, a helper of the drawing.
constexpr double kSameLevel_m = 1.5;

/// "Level 1" -> "Level-1": a name that stands before ids.
std::string word_of(const std::string& name, std::set<std::string>& taken) {
  std::string word;
  for (const char c : name)
    word += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-' ? c : '-';
  if (word.empty()) word = "storey";
  std::string unique = word;
  for (int k = 2; !taken.insert(unique).second; ++k) unique = fmt::format("{}-{}", word, k);
  return unique;
}

int total(const Storey& storey) {
  int sum = 0;
  for (const auto& [source_class, count] : storey.gives) sum += count;
  return sum;
}

/// Of levels that are nearly at one height, the one that gives most; those that give nothing go.
std::vector<Storey> distinct(const std::vector<Storey>& all, std::vector<std::string>& left_out) {
  std::vector<Storey> kept;
  const bool has_heights = std::any_of(all.begin(), all.end(), [](const Storey& s) { return s.elevation_m != 0; });
  for (const Storey& storey : all) {
    if (total(storey) == 0) {
      left_out.push_back(fmt::format("left out: '{}', on which nothing is", storey.name));
    } else if (has_heights && !kept.empty() && storey.elevation_m - kept.back().elevation_m < kSameLevel_m) {
      Storey& below = kept.back();
      const bool is_more = total(storey) > total(below);
      const Storey& gone = is_more ? below : storey;
      const Storey& stays = is_more ? storey : below;
      left_out.push_back(fmt::format("left out: '{}', {:.2f} m from '{}', which shows more", gone.name,
                                     std::abs(storey.elevation_m - below.elevation_m), stays.name));
      if (is_more) below = storey;
    } else {
      kept.push_back(storey);
    }
  }
  return kept;
}

/// @throws opal::ConfigError for a name that no level has.
std::vector<Storey> without(const std::vector<Storey>& all, const std::vector<std::string>& names,
                            std::vector<std::string>& left_out) {
  std::vector<std::string> known;
  for (const Storey& storey : all) known.push_back(in_quotes(storey.name));
  std::vector<Storey> kept = all;
  for (const std::string& name : names) {
    if (std::erase_if(kept, [&](const Storey& storey) { return storey.name == name; }) == 0)
      throw ConfigError("--without: no storey '" + name + "', expected one of " + listed(known));
    left_out.push_back("left out: '" + name + "', as asked for");
  }
  return kept;
}

struct StackFilesOptions : StackVerbOptions {
  std::vector<std::string> maps, words;
  std::string out, name;
  PictureFiles picture;
};

/// "plans/gdc_storey_3.geojson" is called "gdc_storey_3".
std::string stem_of(const std::string& path) {
  const std::string file = std::filesystem::path(path).filename().string();
  return file.substr(0, file.find('.'));
}

/// Maps and imports, one after the other. Plans in degrees take the origin of the first one: each would else lie around
/// its own middle.
class StoreyMaps {
 public:
  StoreyMaps(const PluginRegistry& registry, const std::vector<std::string>& words)
      : registry_(registry), words_(words) {}

  std::shared_ptr<const SemanticMap> load(const std::string& file) {
    if (session::is_map_document(file) || read_store_source(file)) return session::load_map(registry_, file);
    const RegisteredType& type = session::importer_of(registry_, file);
    nlohmann::json options = parse_options(type.info.name, type.options, words_);
    const bool has_origin = options.contains(kOrigin) || options.contains("origin_lon_deg");
    const bool takes_origin = std::any_of(type.options.begin(), type.options.end(),
                                          [](const OptionInfo& option) { return option.name == kOrigin; });
    if (takes_origin && !has_origin && !first_.empty()) options[kOrigin] = first_;
    if (takes_origin && first_.empty()) first_ = file;
    return session::import_map(registry_, file, options).map;
  }

 private:
  static constexpr const char* kOrigin = "origin_file";
  const PluginRegistry& registry_;
  const std::vector<std::string>& words_;
  std::string first_;
};

int stack(const StackFilesOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  StoreyMaps maps(registry, options.words);
  std::set<std::string> taken;
  std::vector<StoreyPart> parts;
  for (const std::string& file : options.maps) {
    const auto map = maps.load(file);
    parts.push_back({word_of(stem_of(file), taken), map->origin().storey, {}, map});
  }
  const std::string name = options.name.empty() ? stem_of(options.out) : options.name;
  const auto map = finished(stacked_map(name, parts, options.stack), options);
  write_map(*map, options.out);
  std::cout << stacked_sentence(options.out, *map) << ", " << count_of(map->features().size(), "feature") << '\n';
  options.picture.write_with_coordinates(map);
  return kDone;
}

}  // namespace

void StackVerbOptions::add_to(CLI::App& verb) {
  verb.add_option("--building", stack.building, "name of the building that the storeys belong to");
  verb.add_option("--gap", stack.gap_m, "between the sheets of the storeys [m]")->capture_default_str();
  verb.add_option("--connections", connections, "lifts and stairs that the sources do not show, as JSON-LD")
      ->check(CLI::ExistingFile);
}

ImportedStoreys import_storeys(const PluginRegistry& registry, const std::string& source, const nlohmann::json& options,
                               const StackVerbOptions& stack) {
  const RegisteredType& type = session::importer_of(registry, source);
  const std::vector<Storey> all = registry.make<MapImporter>(type.info.name, options)->storeys(source);
  if (all.empty()) throw MapError(source + ": has no storeys, expected a source that names some; leave out --all");
  ImportedStoreys imported;
  std::set<std::string> taken;
  for (const Storey& storey : distinct(without(all, stack.without, imported.left_out), imported.left_out)) {
    nlohmann::json one = options;
    one["storey"] = storey.name;
    try {
      imported.imports.push_back(registry.make<MapImporter>(type.info.name, one)->import(source));
    } catch (const MapError& error) {
      imported.left_out.push_back(fmt::format("left out: '{}': {}", storey.name, error.what()));
      continue;
    }
    const bool has_height = imported.imports.back().height_m.has_value();
    imported.parts.push_back({word_of(storey.name, taken), storey.name,
                              has_height ? std::optional(storey.elevation_m) : std::nullopt,
                              imported.imports.back().map});
  }
  if (imported.parts.empty()) throw MapError(source + ": no storey gives a map, expected walls on some");
  imported.stacked = stacked_map(stem_of(source), imported.parts, stack.stack);
  return imported;
}

std::shared_ptr<const SemanticMap> finished(const StackedMap& stacked, const StackVerbOptions& options) {
  const StackedMap all = options.connections.empty() ? stacked : with_connections(stacked, options.connections);
  for (const std::string& sentence : all.report) std::cout << sentence << '\n';
  for (const MapStorey& storey : all.map->origin().storeys)
    std::cout << fmt::format(
        "storey {}: x {:.0f} m, y {:.0f} m to x {:.0f} m, y {:.0f} m; its origin at {:.0f} {:.0f}\n", storey.id,
        storey.bounds[0].x(), storey.bounds[0].y(), storey.bounds[1].x(), storey.bounds[1].y(), storey.origin.x(),
        storey.origin.y());
  return all.map;
}

std::string stacked_sentence(const std::string& out, const SemanticMap& map) {
  return "written: " + out + ", " + count_of(map.origin().storeys.size(), "storey") + ", " +
         count_of(map.origin().connections.size(), "connection");
}

void add_map_stack(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<StackFilesOptions>();
  CLI::App* verb = map.add_subcommand("stack", "make one map of several storeys, or one of several buildings");
  verb->add_option("MAP", options->maps, "map documents, or sources to import; named after their files")->required();
  verb->add_option("-o,--out", options->out, "map document to write (.jsonld)")->required();
  verb->add_option("--name", options->name, "of the map (default: that of the file to write)");
  verb->add_option("--set", options->words,
                   "an option of the importer of all sources, NAME=VALUE or NAME.KEY=TEXT; may be repeated")
      ->allow_extra_args(false);
  options->add_to(*verb);
  options->picture.add_to(*verb);
  verb->callback([options, &exit_code] { exit_code = stack(*options); });
}

}  // namespace opal::cli
