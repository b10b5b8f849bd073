#include "cli/map/map_stack.hpp"
#include "cli/options/exit_code.hpp"

#include "session/session.hpp"

#include "map/map_file.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

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

int total(const opal::Storey& storey) {
  int sum = 0;
  for (const auto& [source_class, count] : storey.gives) sum += count;
  return sum;
}

/// Of levels that are nearly at one height, the one that gives most; those that give nothing go.
std::vector<opal::Storey> distinct(const std::vector<opal::Storey>& all, std::vector<std::string>& left_out) {
  std::vector<opal::Storey> kept;
  const bool has_heights =
      std::any_of(all.begin(), all.end(), [](const opal::Storey& s) { return s.elevation_m != 0; });
  for (const opal::Storey& storey : all) {
    if (total(storey) == 0) {
      left_out.push_back(fmt::format("left out: '{}', on which nothing is", storey.name));
    } else if (has_heights && !kept.empty() && storey.elevation_m - kept.back().elevation_m < kSameLevel_m) {
      opal::Storey& below = kept.back();
      const bool is_more = total(storey) > total(below);
      const opal::Storey& gone = is_more ? below : storey;
      const opal::Storey& stays = is_more ? storey : below;
      left_out.push_back(fmt::format("left out: '{}', {:.2f} m from '{}', which shows more", gone.name,
                                     std::abs(storey.elevation_m - below.elevation_m), stays.name));
      if (is_more) below = storey;
    } else {
      kept.push_back(storey);
    }
  }
  return kept;
}

struct StackFilesOptions : StackVerbOptions {
  std::vector<std::string> maps;
  std::string out, name;
};

/// "plans/gdc_storey_3.geojson" is called "gdc_storey_3".
std::string stem_of(const std::string& path) {
  const std::string file = std::filesystem::path(path).filename().string();
  return file.substr(0, file.find('.'));
}

int stack(const StackFilesOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  std::set<std::string> taken;
  std::vector<opal::StoreyPart> parts;
  for (const std::string& file : options.maps) {
    const auto map = load_map(registry, file);
    parts.push_back({word_of(stem_of(file), taken), map->origin().storey, {}, map});
  }
  const std::string name = options.name.empty() ? stem_of(options.out) : options.name;
  const auto map = finished(opal::stacked_map(name, parts, options.stack), options);
  opal::write_map(*map, options.out);
  std::cout << "written: " << options.out << ", " << map->origin().storeys.size() << " storeys, "
            << map->origin().connections.size() << " connections, " << map->features().size() << " features\n";
  return kDone;
}

}  // namespace

void StackVerbOptions::add_to(CLI::App& verb) {
  verb.add_option("--building", stack.building, "name of the building that the storeys belong to");
  verb.add_option("--gap", stack.gap_m, "between the sheets of the storeys [m]")->capture_default_str();
  verb.add_option("--connections", connections, "lifts and stairs that the sources do not show, as JSON-LD")
      ->check(CLI::ExistingFile);
}

ImportedStoreys import_storeys(const opal::PluginRegistry& registry, const std::string& source,
                               const nlohmann::json& options, const StackVerbOptions& stack) {
  const opal::RegisteredType& type = importer_of(registry, source);
  const std::vector<opal::Storey> all = registry.make<opal::MapImporter>(type.info.name, options)->storeys(source);
  if (all.empty())
    throw opal::MapError(source + ": has no storeys, expected a source that names some; leave out --all");
  ImportedStoreys imported;
  std::set<std::string> taken;
  for (const opal::Storey& storey : distinct(all, imported.left_out)) {
    nlohmann::json one = options;
    one["storey"] = storey.name;
    try {
      imported.imports.push_back(registry.make<opal::MapImporter>(type.info.name, one)->import(source));
    } catch (const opal::MapError& error) {
      imported.left_out.push_back(fmt::format("left out: '{}': {}", storey.name, error.what()));
      continue;
    }
    const bool has_height = imported.imports.back().height_m.has_value();
    imported.parts.push_back({word_of(storey.name, taken), storey.name,
                              has_height ? std::optional(storey.elevation_m) : std::nullopt,
                              imported.imports.back().map});
  }
  if (imported.parts.empty()) throw opal::MapError(source + ": no storey gives a map, expected walls on some");
  imported.stacked = opal::stacked_map(stem_of(source), imported.parts, stack.stack);
  return imported;
}

std::shared_ptr<const opal::SemanticMap> finished(const opal::StackedMap& stacked, const StackVerbOptions& options) {
  for (const std::string& sentence : stacked.report) std::cout << sentence << '\n';
  auto map = options.connections.empty() ? stacked.map : opal::with_connections(*stacked.map, options.connections);
  for (const opal::MapStorey& storey : map->origin().storeys)
    std::cout << fmt::format(
        "storey {}: x {:.0f} m, y {:.0f} m to x {:.0f} m, y {:.0f} m; its origin at {:.0f} {:.0f}\n", storey.id,
        storey.bounds[0].x(), storey.bounds[0].y(), storey.bounds[1].x(), storey.bounds[1].y(), storey.origin.x(),
        storey.origin.y());
  return map;
}

void add_map_stack(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<StackFilesOptions>();
  CLI::App* verb = map.add_subcommand("stack", "make one map of several storeys, or one of several buildings");
  verb->add_option("MAP", options->maps, "map documents, or sources to import; named after their files")->required();
  verb->add_option("-o,--out", options->out, "map document to write (.jsonld)")->required();
  verb->add_option("--name", options->name, "of the map (default: that of the file to write)");
  options->add_to(*verb);
  verb->callback([options, &exit_code] { exit_code = stack(*options); });
}
