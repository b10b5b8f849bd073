#include "cli/map/map_derive.hpp"

#include "benchmark/runs/progress_bar.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/picture_files.hpp"
#include "map/map_file.hpp"
#include "map_tools/map_raster.hpp"
#include "session/session.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

namespace opal::cli {
namespace {

struct DeriveOptions {
  std::string map, out, detector;
  PictureFiles picture;
  std::vector<std::string> words;
  DerivationOptions derivation;
};

bool has_doors(const SemanticMap& map) {
  return std::ranges::any_of(map.features(), [&](const MapFeature& feature) { return is_door_leaf(map, feature); });
}

void draw(const Derivation& derivation, const DeriveOptions& options) {
  DrawingScene scene = scene_of(derivation.map);
  scene.notes = {std::to_string(derivation.added.size()) + " features derived by " + options.detector};
  options.picture.write(scene);
}

int derive(const DeriveOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  const auto map = session::load_map(registry, options.map);
  const Derivation derivation = derived_by(registry, *map, options.detector, options.words, options.derivation);
  for (const std::string& id : derivation.added) std::cout << "  " << id << '\n';
  write_map(*derivation.map, options.out);
  std::cout << "written: " << options.out << '\n';
  draw(derivation, options);
  return derivation.added.empty() ? kNo : kDone;
}

}  // namespace

Derivation derived_by(const PluginRegistry& registry, const SemanticMap& map, const std::string& detector,
                      const std::vector<std::string>& words, const DerivationOptions& options) {
  const RegisteredType& type = registry.type(detector);
  if (type.kind != PluginKind::feature_detector)
    throw ConfigError(detector + ": is a " + name_of(type.kind) + ", expected a FeatureDetector (`opal plugins`)");
  const auto part = registry.make<FeatureDetector>(detector, parse_options(detector, type.options, words));
  const std::string description = std::filesystem::path(type.file).replace_extension(".jsonld").string();
  benchmark::ProgressBar bar;
  DerivationOptions watched = options;
  watched.progress = [&bar](double share) { bar.show(share, "of the places to look from"); };
  Derivation derivation =
      derived_features(map, *part, type.info.produces, watched, read_plugin_description(description).prefixes);
  bar.clear();
  std::cout << detector << ": " << derivation.added.size() << " new features, seen from " << derivation.places
            << " places; " << derivation.known << " known before, " << derivation.twice
            << " found twice; left out: " << derivation.seldom << " seen too seldom, " << derivation.on_nothing
            << " on no object\n";
  if (derivation.added.empty() && !options.doors_open && has_doors(map))
    std::cout << "  all doors were shut; --doors-open looks through them\n";
  return derivation;
}

void add_map_derive(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<DeriveOptions>();
  DerivationOptions& derivation = options->derivation;
  CLI::App* verb = map.add_subcommand("derive", "add the features that a detector would find on what is mapped");
  verb->add_option("MAP", options->map, "map document, or a source to import")->required();
  verb->add_option("-o,--out", options->out, "map document to write (.jsonld)")->required();
  verb->add_option("--detector", options->detector, "type name of a detector: acme:PostDetector")->required();
  verb->add_option("--set", options->words, "an option of the detector, NAME=VALUE; may be repeated")
      ->allow_extra_args(false);
  verb->add_option("--sensor", derivation.sensor, "id of the sensor that perceives them")->capture_default_str();
  verb->add_option("--spacing", derivation.spacing_m, "between the places to look from [m]")
      ->check(in_range(0.2, 10.0))
      ->capture_default_str();
  verb->add_option("--reach", derivation.reach_m, "how far the laser sees [m]")
      ->check(in_range(1.0, 100.0))
      ->capture_default_str();
  verb->add_flag("--doors-open", derivation.doors_open, "doors stand open, as if they had no leaf; without it: shut");
  options->picture.add_to(*verb);
  verb->callback([options, &exit_code] { exit_code = derive(*options); });
}

}  // namespace opal::cli
