#include "cli/map/map_redraw.hpp"

#include "cli/options/exit_code.hpp"
#include "common/whole_file.hpp"
#include "evaluation/ground_truth.hpp"
#include "evaluation/site.hpp"
#include "map_tools/test_maps/cone_mapping.hpp"
#include "session/session.hpp"

#include <opal/common/error.hpp>
#include <opal/deployment/deployment.hpp>
#include <opal/sensing/replay.hpp>

#include <filesystem>
#include <iostream>
#include <memory>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;

struct RedrawOptions {
  std::vector<std::string> prefixes;
  std::string folder;
  ConeMapping mapping;
};

/// The scans whose place the truth tells, in the order of the drive.
std::vector<PlacedScan> placed_scans(const PluginRegistry& registry, const std::string& prefix) {
  const LaserModel laser = read_site_laser(prefix + ".info.json");
  const GroundTruth truth = GroundTruth::read(prefix + ".gt.csv");
  const std::string file = prefix + ".log.gz";
  Replay replay(session::open_log(registry, file, {}), {laser});
  std::vector<PlacedScan> scans;
  while (auto sample = replay.next())
    if (const auto pose = truth.T_map_laser_at(sample->stamp_s))
      scans.push_back({std::move(sample->views.front().scan), *pose});
  if (scans.empty()) throw ConfigError(prefix + ".gt.csv: tells the place of no scan of " + file);
  return scans;
}

void redraw(const PluginRegistry& registry, const std::string& prefix, const RedrawOptions& options) {
  const std::string out =
      (fs::path(options.folder) / (fs::path(prefix).filename().string() + ".map.yaml")).lexically_normal().string();
  const MapRaster raster = cone_mapped(placed_scans(registry, prefix), options.mapping);
  write_raster(raster, out);
  std::cout << "written: " << out << ", " << raster.columns << " x " << raster.rows << " cells of "
            << raster.resolution_m << " m\n";
}

int redraw(const RedrawOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  make_folder(options.folder);
  for (const std::string& prefix : options.prefixes) redraw(registry, prefix, options);
  return kDone;
}

}  // namespace

void add_map_redraw(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<RedrawOptions>();
  ConeMapping& mapping = options->mapping;
  CLI::App* verb = map.add_subcommand(
      "redraw", "the grid that another team draws of a recorded place, with wide beams at poses that drift");
  verb->add_option("PREFIX", options->prefixes,
                   "recorded places: PREFIX.info.json, PREFIX.log.gz and PREFIX.gt.csv are read")
      ->required();
  verb->add_option("-o,--out", options->folder, "folder for a grid per place: NAME.map.yaml and NAME.map.pgm")
      ->required();
  const auto number = [verb](const char* name, double& value, const char* help) {
    verb->add_option(name, value, help)->capture_default_str();
  };
  number("--cone", mapping.cone_rad, "opening of a beam [rad]");
  number("--noise", mapping.range_sigma_m, "one sigma of a range [m]");
  number("--reach", mapping.reach_m, "how far a beam sees [m]");
  number("--drift", mapping.drift_m, "one sigma of the poses' error [m]");
  number("--turn", mapping.drift_rad, "the same for the heading [rad]");
  number("--resolution", mapping.resolution_m, "side of a cell [m]");
  number("--blur", mapping.blur_m, "one sigma of what smooths the map [m]");
  verb->add_option("--seed", mapping.seed, "the same seed gives the same map")->capture_default_str();
  verb->callback([options, &exit_code] { exit_code = redraw(*options); });
}

}  // namespace opal::cli
