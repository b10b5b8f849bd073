#include "cli/map/map_generate.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/picture_files.hpp"

#include <opal/common/error.hpp>
#include "map/map_file.hpp"

#include <iostream>
#include <memory>
#include "simulation/buildings/building.hpp"

namespace opal::cli {
namespace {

using simulation::BuildingKind;

struct GenerateOptions {
  simulation::BuildingRequest building;
  std::string out;
  PictureFiles picture;
};

const BuildingKind* kind_named(const std::string& name) {
  for (const BuildingKind& kind : simulation::building_kinds())
    if (kind.name == name) return &kind;
  return nullptr;
}

std::string description_of_kinds() {
  std::string text = "what to build";
  for (const BuildingKind& kind : simulation::building_kinds()) text += "; " + kind.name + ": " + kind.description;
  return text;
}

/// There is one Atlas: a seed for it would be dropped.
void refuse_choice(const CLI::App& verb, const std::string& name) {
  const BuildingKind* kind = kind_named(name);
  if (!kind || kind->usual_size_m2 > 0) return;
  for (const char* option : {"--seed", "--size", "--symmetry"})
    if (verb.count(option) > 0) throw ConfigError(std::string(option) + ": there is only one " + name);
}

int generate(const GenerateOptions& options) {
  const simulation::Building building = generate_building(options.building);
  write_map(*building.map, options.out);
  std::cout << "written: " << options.out << ", " << building.map->features().size() << " features of "
            << building.map->objects().size() << " objects\n";
  options.picture.write(scene_of(building.map));
  return kDone;
}

}  // namespace

void add_map_generate(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* verb = map.add_subcommand("generate", "make a building of our own, to drive in with a simulator");
  verb->add_option("KIND", options->building.kind, description_of_kinds())->required();
  verb->add_option("-o,--out", options->out, "map document to write (.jsonld)")->required();
  verb->add_option("--seed", options->building.seed, "the same seed gives the same building")->capture_default_str();
  verb->add_option("--size", options->building.size_m2, "about how large it is [m^2]; 0: as is usual for the kind")
      ->capture_default_str();
  verb->add_option("--symmetry", options->building.symmetry, "0: all parts differ; 1: all are copies of one")
      ->capture_default_str();
  options->picture.add_to(*verb);
  verb->callback([options, verb, &exit_code] {
    refuse_choice(*verb, options->building.kind);
    exit_code = generate(*options);
  });
}

}  // namespace opal::cli
