#include "cli/map/map_patterns.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/picture_files.hpp"

#include "session/session.hpp"

#include <opal/common/error.hpp>
#include "deployment/pipeline_plan.hpp"
#include "map/map_file.hpp"
#include "patterns/consuming_template.hpp"
#include "patterns/pattern_layer.hpp"

#include <algorithm>
#include <iostream>

namespace opal::cli {
namespace {

using Templates = std::vector<Named<PatternTemplate>>;
using Map = std::shared_ptr<const SemanticMap>;

struct PatternsOptions {
  std::string map, out, sensor = "PlanarLidar2D";
  PictureFiles picture;
  std::vector<std::string> templates;
  PatternLayerOptions layer;
  bool summary = false;
};

std::shared_ptr<const PatternTemplate> made(const PluginRegistry& registry, const std::string& name) {
  return consuming(registry.make<PatternTemplate>(name), registry.type(name).info.consumes);
}

/// Several features, of which one at least has a place: lines alone do better without a layer, joined to whole walls.
bool is_usual(const PatternTemplate& pattern_template) {
  const auto slots = pattern_template.shape().slots;
  const bool placed = std::any_of(slots.begin(), slots.end(), [](auto kind) { return kind != GeometryKind::segment; });
  return slots.size() > 1 && placed;
}

/// What the map has features for: all usual templates, or the ones named.
Templates chosen_templates(const PluginRegistry& registry, const SemanticMap& map, const PatternsOptions& options) {
  const PipelinePlan plan = plan_pipeline(*map.with_patterns({}), options.sensor, registry.types());
  std::vector<std::string> usable = plan.patterns;
  usable.insert(usable.end(), plan.on_request.begin(), plan.on_request.end());
  const std::vector<std::string>& asked = options.templates.empty() ? usable : options.templates;
  Templates chosen;
  for (const std::string& name : asked) {
    if (std::find(usable.begin(), usable.end(), name) == usable.end()) {
      registry.type(name);  // says what there is, if there is none of this name
      std::string message = name + " cannot be used with " + options.map;
      for (const std::string& reason : plan.reasons)
        if (reason.rfind(name + ":", 0) == 0) message += "\n  " + reason;
      throw ConfigError(message);
    }
    auto part = made(registry, name);
    if (!options.templates.empty() || is_usual(*part)) chosen.push_back({name, std::move(part)});
  }
  if (chosen.empty()) throw ConfigError(options.map + ": no pattern template has the features that it needs");
  return chosen;
}

void print(const SemanticMap& map, const PatternLayer& layer, bool each) {
  for (std::size_t k = 0; each && k < layer.patterns.size(); ++k) {
    const MapPattern& pattern = layer.patterns[k];
    std::cout << pattern.id << ": ";
    if (layer.alike[k] == 0) std::cout << "unique;";
    if (layer.alike[k] > 0) std::cout << layer.alike[k] << (layer.alike[k] == 1 ? " look-alike;" : " look-alikes;");
    for (const MapFeatureNumber member : pattern.features) std::cout << ' ' << map.feature(member).id;
    std::cout << '\n';
  }
  for (const PatternSummary& summary : layer.summaries) std::cout << sentence_of(summary) << '\n';
}

void draw(const Map& map, const PatternLayer& layer, const PictureFiles& picture) {
  DrawingScene scene = scene_of(map);
  scene.coordinates = true;
  for (const MapPattern& pattern : layer.patterns) {
    scene.patterns.emplace_back();
    for (const MapFeatureNumber member : pattern.features)
      scene.patterns.back().push_back(anchor_of(map->feature(member).geometry));
  }
  for (const PatternSummary& summary : layer.summaries) scene.notes.push_back(sentence_of(summary));
  picture.write(scene);
}

int patterns(const PatternsOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  const Map map = session::load_map(registry, options.map);
  const MapView view(map, options.sensor);
  const PatternLayer layer = find_pattern_layer(view, chosen_templates(registry, *map, options), options.layer);
  print(*map, layer, !options.summary);
  draw(map, layer, options.picture);
  if (!options.out.empty()) {
    write_map(*map->with_patterns(layer.patterns), options.out);
    std::cout << "written: " << options.out << '\n';
  }
  return layer.patterns.empty() ? kNo : kDone;
}

}  // namespace

void add_map_patterns(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<PatternsOptions>();
  CLI::App* verb =
      map.add_subcommand("patterns", "find patterns of features, say how unique they are, add them to the map");
  verb->add_option("MAP", options->map, "map document, or a source to import")->required();
  verb->add_option("-o,--out", options->out, "map document to write (.jsonld)");
  verb->add_option("--template", options->templates,
                   "type name of a pattern template; all that the map has features for");
  verb->add_option("--size", options->layer.size_m, "how far neighbours in a pattern may be apart [m]")
      ->check(in_range(0.1, 100.0))
      ->capture_default_str();
  verb->add_option("--sensor", options->sensor, "id of the sensor that perceives them")->capture_default_str();
  options->picture.add_to(*verb, "also draw map and patterns into this file");
  verb->add_flag("--summary", options->summary, "say only what holds per template, not of each pattern");
  verb->callback([options, &exit_code] { exit_code = patterns(*options); });
}

void check_layer(const PluginRegistry& registry, const Map& map, const std::string& sensor) {
  if (map->patterns().empty()) return;
  const PipelinePlan plan = plan_pipeline(*map, sensor, registry.types());
  Templates templates;
  for (const std::string& name : plan.patterns) templates.push_back({name, made(registry, name)});
  for (const PatternSummary& summary : read_pattern_layer(MapView(map, sensor), templates).summaries)
    std::cout << sentence_of(summary) << '\n';
}

}  // namespace opal::cli
