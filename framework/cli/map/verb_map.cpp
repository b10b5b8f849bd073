#include "cli/map/map_derive.hpp"
#include "cli/map/map_fleet.hpp"
#include "cli/map/map_frame.hpp"
#include "cli/map/map_generate.hpp"
#include "cli/map/map_import.hpp"
#include "cli/map/map_overlay.hpp"
#include "cli/map/map_patterns.hpp"
#include "cli/map/map_redraw.hpp"
#include "cli/map/map_review.hpp"
#include "cli/map/map_sketch.hpp"
#include "cli/map/map_stack.hpp"
#include "cli/options/damage_options.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/join_options.hpp"
#include "cli/options/overlay_options.hpp"
#include "cli/options/verbs.hpp"
#include "session/overlays.hpp"
#include "session/session.hpp"

#include <opal/common/error.hpp>
#include "common/phrases.hpp"
#include "deployment/pipeline_plan.hpp"
#include "map/check/map_check.hpp"
#include "map/map_file.hpp"
#include "map_tools/map_raster.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

namespace opal::cli {
namespace {

struct CheckOptions {
  std::string map, sensor = "PlanarLidar2D";
  OverlayFiles overlays;
};

/// A line each, but one for all that nothing asks for.
void tell_reasons(const PipelinePlan& plan) {
  std::vector<std::string> idle;
  for (const std::string& reason : plan.reasons) {
    const auto named = std::find_if(plan.on_request.begin(), plan.on_request.end(),
                                    [&](const std::string& name) { return reason.starts_with(name + ":"); });
    if (named == plan.on_request.end())
      std::cout << reason << '\n';
    else
      idle.push_back(*named);
  }
  if (!idle.empty())
    std::cout << "not running, as neither patterns of the map nor a deployment name them: " << listed(idle) << '\n';
}

int check(const CheckOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  const auto map = session::with_overlays(session::load_map(registry, options.map), options.overlays.files);
  for (const std::string& sentence : check_map(*map).sentences()) std::cout << sentence << '\n';
  const PipelinePlan plan = plan_pipeline(*map, options.sensor, registry.types());
  tell_reasons(plan);
  check_layer(registry, map, options.sensor);
  return plan.detectors.empty() || plan.patterns.empty() ? kNo : kDone;
}

void add_check(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* verb = map.add_subcommand("check", "what is in a map, what is odd about it, and what it makes run");
  verb->add_option("MAP", options->map, "map document, or a source to import")->required();
  verb->add_option("--sensor", options->sensor, "id of the sensor that is asked about")->capture_default_str();
  options->overlays.add_to(*verb);
  verb->callback([options, &exit_code] { exit_code = check(*options); });
}

struct DamageVerbOptions {
  std::string map, out;
  DamageOptions damage;
};

int damage(const DamageVerbOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  const auto worse = session::load_map(registry, options.map, options.damage.damage());
  write_map(*worse, options.out);
  std::cout << "written: " << options.out << ", " << worse->features().size() << " features of "
            << session::load_map(registry, options.map)->features().size() << '\n';
  return kDone;
}

void add_damage(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<DamageVerbOptions>();
  CLI::App* verb =
      map.add_subcommand("damage", "make a map worse in a known way, to see what localization makes of it");
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

/// All of them, or the first few of thousands.
void tell_places(const std::vector<MapPlacement>& placements) {
  constexpr std::size_t kMost = 30;
  for (std::size_t k = 0; k < std::min(kMost, placements.size()); ++k) {
    const MapPlacement& placement = placements[k];
    fmt::print("{}: moved by {:.0f} m, {:.0f} m; scale {:.3f}, {:.3f}\n", placement.id, placement.T_map_source.x(),
               placement.T_map_source.y(), placement.scale.x(), placement.scale.y());
  }
  if (placements.size() > kMost) fmt::print("and {} more\n", placements.size() - kMost);
}

int join(const JoinVerbOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  std::vector<MapSourcePart> sources;
  for (const std::string& map : options.maps)
    sources.push_back({session::name_of_map(map), session::load_map(registry, map)});
  const auto joined = joined_map(sources, options.join.join);
  write_map(*joined, options.out);
  tell_places(joined->origin().placements);
  for (const MapSourcePart& source : sources)
    if (!source.map->unused().empty())
      fmt::print("left out of {}: what other vocabularies say about {} things\n", source.prefix,
                 source.map->unused().size());
  std::cout << "written: " << options.out << ", " << joined->features().size() << " features\n";
  return kDone;
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
  RasterOptions raster;
};

int raster(const RasterVerbOptions& options) {
  const std::string extension = std::filesystem::path(options.out).extension().string();
  if (extension != ".yaml" && extension != ".yml")
    throw ConfigError(options.out + ": expected a name that ends with .yaml; the image goes beside it (.pgm)");
  const auto map = session::load_map(session::load_plugins(), options.map);
  const MapRaster raster = rasterized(*map, options.raster);
  write_raster(raster, options.out);
  std::cout << "written: " << options.out << ", " << raster.columns << " x " << raster.rows << " cells of "
            << raster.resolution_m << " m\n";
  return kDone;
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

void add_map_verb(CLI::App& app, int& exit_code) {
  CLI::App* map = app.add_subcommand(
      "map",
      "semantic maps: import, storeys, stack, check, patterns, derive, frame, overlay, review, damage, join, "
      "raster, redraw, sketch, push, pull, list, diff, generate");
  map->require_subcommand(1);
  add_map_import(*map, exit_code);
  add_map_storeys(*map, exit_code);
  add_map_stack(*map, exit_code);
  add_check(*map, exit_code);
  add_map_patterns(*map, exit_code);
  add_map_derive(*map, exit_code);
  add_map_frame(*map, exit_code);
  add_map_overlay(*map, exit_code);
  add_map_review(*map, exit_code);
  add_damage(*map, exit_code);
  add_join(*map, exit_code);
  add_raster(*map, exit_code);
  add_map_redraw(*map, exit_code);
  add_map_sketch(*map, exit_code);
  add_map_fleet(*map, exit_code);
  add_map_diff(*map, exit_code);
  add_map_generate(*map, exit_code);
}

}  // namespace opal::cli
