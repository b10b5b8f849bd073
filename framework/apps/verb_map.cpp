#include "damage_options.hpp"
#include "join_options.hpp"
#include "map_generate.hpp"
#include "map_patterns.hpp"
#include "session.hpp"
#include "verbs.hpp"

#include <opal/deployment.hpp>
#include <opal/drawing.hpp>
#include <opal/error.hpp>
#include <opal/map_check.hpp>
#include <opal/map_raster.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

namespace {

struct ImportOptions {
  std::string source, out, svg, png, report;
  double thicken_m = 0;
};

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  if (!(file << text)) throw opal::Error(path + ": cannot be written");
}

int import(const ImportOptions& options) {
  const opal::MapImport imported = import_map(load_plugins(), options.source, options.thicken_m);
  write_text(options.out, imported.map->to_json_ld().dump(1) + '\n');
  std::string report;
  for (const std::string& sentence : imported.report) report += sentence + '\n';
  std::cout << report << "written: " << options.out << '\n';
  if (!options.report.empty()) write_text(options.report, report);
  opal::DrawingScene scene;
  scene.title = imported.map->name();
  scene.map = imported.map;
  if (!options.svg.empty()) opal::write_svg(scene, options.svg);
  if (!options.png.empty()) opal::write_png(scene, options.png);
  return 0;
}

void add_import(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* verb = map.add_subcommand("import", "make a semantic map of a ROS map_server grid (yaml)");
  verb->add_option("SOURCE", options->source, "what to import")->required();
  verb->add_option("-o,--out", options->out, "map document to write (.jsonld)")->required();
  verb->add_option("--svg", options->svg, "also draw the map into this file");
  verb->add_option("--png", options->png, "the same as a PNG");
  verb->add_option("--report", options->report, "also write the report into this file");
  verb->add_option("--thicken", options->thicken_m,
                   "for experiments: make walls of a grid so much thicker first, and its cells 0.1 m [m]");
  verb->callback([options, &exit_code] { exit_code = import(*options); });
}

struct CheckOptions {
  std::string map, sensor = "PlanarLidar2D";
};

int check(const CheckOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  const auto map = load_map(registry, options.map);
  for (const std::string& sentence : opal::check_map(*map).sentences()) std::cout << sentence << '\n';
  const opal::PipelinePlan plan = opal::plan_pipeline(*map, options.sensor, registry.types());
  for (const std::string& reason : plan.reasons) std::cout << reason << '\n';
  check_layer(registry, map, options.sensor);
  return plan.detectors.empty() || plan.patterns.empty() ? 1 : 0;
}

void add_check(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* verb = map.add_subcommand("check", "what is in a map, what is odd about it, and what it makes run");
  verb->add_option("MAP", options->map, "map document, or a source to import")->required();
  verb->add_option("--sensor", options->sensor, "id of the sensor that is asked about")->capture_default_str();
  verb->callback([options, &exit_code] { exit_code = check(*options); });
}

struct DamageVerbOptions {
  std::string map, out;
  DamageOptions damage;
};

int damage(const DamageVerbOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  const auto worse = load_map(registry, options.map, options.damage.damage());
  write_text(options.out, worse->to_json_ld().dump(1) + '\n');
  std::cout << "written: " << options.out << ", " << worse->features().size() << " features of "
            << load_map(registry, options.map)->features().size() << '\n';
  return 0;
}

void add_damage(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<DamageVerbOptions>();
  CLI::App* verb = map.add_subcommand("damage", "make a map worse in a known way, to see what localization makes of it");
  verb->add_option("MAP", options->map, "map document, or a source to import")->required();
  verb->add_option("-o,--out", options->out, "map document to write (.jsonld)")->required();
  options->damage.add_to(*verb);
  verb->callback([options, &exit_code] { exit_code = damage(*options); });
}

struct JoinVerbOptions {
  std::vector<std::string> maps;
  std::string out;
  JoinOptions join;
};

/// "maps/acapulco.map.yaml" is called "acapulco".
std::string name_of(const std::string& path) {
  const std::string file = std::filesystem::path(path).filename().string();
  return file.substr(0, file.find('.'));
}

int join(const JoinVerbOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  std::vector<opal::MapSourcePart> sources;
  for (const std::string& map : options.maps) sources.push_back({name_of(map), load_map(registry, map)});
  const auto joined = opal::joined_map(sources, options.join.join);
  write_text(options.out, joined->to_json_ld().dump(1) + '\n');
  for (const opal::MapPlacement& placement : joined->origin().placements)
    std::printf("%s: moved by %.0f m, %.0f m; scale %.3f, %.3f\n", placement.id.c_str(), placement.T_map_source.x(),
                placement.T_map_source.y(), placement.scale.x(), placement.scale.y());
  for (const opal::MapSourcePart& source : sources)
    if (!source.map->unused().empty())
      std::printf("left out of %s: what other vocabularies say about %zu things\n", source.prefix.c_str(),
                  source.map->unused().size());
  std::cout << "written: " << options.out << ", " << joined->features().size() << " features\n";
  return 0;
}

void add_join(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<JoinVerbOptions>();
  CLI::App* verb = map.add_subcommand("join", "put maps side by side in one map, with look-alikes if wanted");
  verb->add_option("MAP", options->maps, "map documents, or sources to import; named after their files")->required();
  verb->add_option("-o,--out", options->out, "map document to write (.jsonld)")->required();
  options->join.add_to(*verb);
  verb->add_option("--seed", options->join.join.seed, "of the copies: the same seed gives the same map")
      ->capture_default_str();
  verb->callback([options, &exit_code] { exit_code = join(*options); });
}

struct RasterVerbOptions {
  std::string map, out;
  opal::RasterOptions raster;
};

int raster(const RasterVerbOptions& options) {
  const auto map = load_map(load_plugins(), options.map);
  const opal::MapRaster raster = opal::rasterized(*map, options.raster);
  opal::write_raster(raster, options.out);
  std::cout << "written: " << options.out << ", " << raster.columns << " x " << raster.rows << " cells of "
            << raster.resolution_m << " m\n";
  return 0;
}

void add_raster(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<RasterVerbOptions>();
  CLI::App* verb = map.add_subcommand("raster", "make a ROS map_server grid (yaml and pgm) of a semantic map");
  verb->add_option("MAP", options->map, "map document, or a source to import")->required();
  verb->add_option("-o,--out", options->out, "grid to write (.yaml); the image goes beside it (.pgm)")->required();
  verb->add_option("--resolution", options->raster.resolution_m, "side of a cell [m]")->capture_default_str();
  verb->add_option("--border", options->raster.border_m, "around everything that is mapped [m]")->capture_default_str();
  verb->callback([options, &exit_code] { exit_code = raster(*options); });
}

}  // namespace

void opal::add_map_verb(CLI::App& app, int& exit_code) {
  CLI::App* map = app.add_subcommand("map", "semantic maps: import, check, patterns, damage, join, raster, generate");
  map->require_subcommand(1);
  add_import(*map, exit_code);
  add_check(*map, exit_code);
  add_map_patterns(*map, exit_code);
  add_damage(*map, exit_code);
  add_join(*map, exit_code);
  add_raster(*map, exit_code);
  add_map_generate(*map, exit_code);
}
