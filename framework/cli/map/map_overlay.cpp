#include "cli/map/map_overlay.hpp"
#include "cli/options/exit_code.hpp"

#include "session/session.hpp"

#include <opal/common/error.hpp>
#include "drawing/drawing.hpp"
#include "map/map_file.hpp"
#include "map/overlay/map_overlay.hpp"

#include <iostream>
#include <memory>

namespace opal::cli {
namespace {

struct OverlayVerbOptions {
  std::string map, out, svg, png;
  std::vector<std::string> overlays;
  OverlayOptions overlay;
};

void draw(const std::shared_ptr<const SemanticMap>& map, const OverlayVerbOptions& options) {
  DrawingScene scene;
  scene.title = map->name();
  scene.map = map;
  if (!options.svg.empty()) write_svg(scene, options.svg);
  if (!options.png.empty()) write_png(scene, options.png);
}

int overlay(const OverlayVerbOptions& options) {
  std::vector<MapOverlay> overlays;
  for (const std::string& file : options.overlays) overlays.push_back(read_overlay(file));
  const OverlaidMap overlaid =
      overlaid_map(*session::load_map(session::load_plugins(), options.map), overlays, options.overlay);
  for (const std::string& sentence : overlaid.changes) std::cout << sentence << '\n';
  for (const std::string& doubt : overlaid.doubts) std::cout << "does not fit: " << doubt << '\n';
  write_map(*overlaid.map, options.out);
  std::cout << "written: " << options.out << '\n';
  draw(overlaid.map, options);
  return overlaid.doubts.empty() ? kDone : kNo;
}

}  // namespace

void add_map_overlay(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<OverlayVerbOptions>();
  CLI::App* verb =
      map.add_subcommand("overlay", "change a map by overlay documents, and leave what was imported as it is");
  verb->add_option("MAP", options->map, "map document, or a source to import")->required();
  verb->add_option("OVERLAY", options->overlays, "overlay documents (.jsonld); their order means nothing")->required();
  verb->add_option("-o,--out", options->out, "map document to write (.jsonld)")->required();
  verb->add_option("--svg", options->svg, "also draw the map into this file");
  verb->add_option("--png", options->png, "the same as a PNG");
  verb->add_flag("--report-missing", options->overlay.report_missing,
                 "after a new import: tell all changes whose target is gone, and make the others");
  verb->callback([options, &exit_code] { exit_code = overlay(*options); });
}

}  // namespace opal::cli
