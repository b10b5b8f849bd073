#include "cli/map/map_overlay.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/picture_files.hpp"

#include "session/session.hpp"

#include "map/map_file.hpp"
#include "map/overlay/map_overlay.hpp"

#include <iostream>
#include <memory>

namespace opal::cli {
namespace {

struct OverlayVerbOptions {
  std::string map, out;
  PictureFiles picture;
  std::vector<std::string> overlays;
  OverlayOptions overlay;
};

int overlay(const OverlayVerbOptions& options) {
  std::vector<MapOverlay> overlays;
  for (const std::string& file : options.overlays) overlays.push_back(read_overlay(file));
  const OverlaidMap overlaid =
      overlaid_map(*session::load_map(session::load_plugins(), options.map), overlays, options.overlay);
  for (const std::string& sentence : overlaid.changes) std::cout << sentence << '\n';
  for (const std::string& doubt : overlaid.doubts) std::cout << "does not fit: " << doubt << '\n';
  write_map(*overlaid.map, options.out);
  std::cout << "written: " << options.out << '\n';
  options.picture.write(scene_of(overlaid.map));
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
  options->picture.add_to(*verb);
  verb->add_flag("--report-missing", options->overlay.report_missing,
                 "after a new import: tell all changes whose target is gone, and make the others");
  verb->callback([options, &exit_code] { exit_code = overlay(*options); });
}

}  // namespace opal::cli
