#include "cli/map/map_sketch.hpp"

#include "cli/options/exit_code.hpp"
#include "common/whole_file.hpp"
#include "map_tools/test_maps/plan_sketch.hpp"
#include "session/session.hpp"

#include <filesystem>
#include <iostream>
#include <memory>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;

struct SketchOptions {
  std::vector<std::string> maps;
  std::string folder;
  bool printed = false;
  std::optional<double> furniture, words;
  std::uint64_t seed = 1;
};

PlanSketch plan_of(const SketchOptions& options) {
  PlanSketch plan = options.printed ? printed_and_scanned() : drawn_by_hand();
  plan.furniture = options.furniture.value_or(plan.furniture);
  plan.words = options.words.value_or(plan.words);
  plan.seed = options.seed;
  return plan;
}

int sketch(const SketchOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  make_folder(options.folder);
  for (const std::string& map : options.maps) {
    const std::string out =
        (fs::path(options.folder) / (session::name_of_map(map) + ".map.yaml")).lexically_normal().string();
    const MapRaster raster = sketched(*session::load_map(registry, map), plan_of(options));
    write_raster(raster, out);
    std::cout << "written: " << out << ", " << raster.columns << " x " << raster.rows << " cells of "
              << raster.resolution_m << " m\n";
  }
  return kDone;
}

}  // namespace

void add_map_sketch(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<SketchOptions>();
  CLI::App* verb =
      map.add_subcommand("sketch", "the plan of a map as a person draws it by hand, or as a scanner reads it");
  verb->add_option("MAP", options->maps, "map documents, or sources to import")->required();
  verb->add_option("-o,--out", options->folder, "folder for a grid per map: NAME.map.yaml and NAME.map.pgm")
      ->required();
  verb->add_flag("--printed", options->printed,
                 "both faces of walls, printed, and scanned with some dirt; else single lines by hand");
  verb->add_option("--furniture", options->furniture, "outlines of furniture per 100 m2 of floor (default: 4)");
  verb->add_option("--words", options->words, "names and numbers per 100 m2 of floor (default: 2)");
  verb->add_option("--seed", options->seed, "the same seed gives the same plan")->capture_default_str();
  verb->callback([options, &exit_code] { exit_code = sketch(*options); });
}

}  // namespace opal::cli
