#include "cli/options/log_run_options.hpp"

#include "sensing/log_check.hpp"
#include "session/shipped_files.hpp"

#include <opal/common/error.hpp>

#include <limits>

void LogRunOptions::add_to(CLI::App& verb, const std::string& written) {
  verb.add_option("CONFIG", config, "deployment document, or the name of one that ships: default, malaga")->required();
  verb.add_option("LOG", log, "recorded log (CARMEN text, .gz too; ROS 2 bag .db3, MCAP, ROS 1 bag)")->required();
  verb.add_option("-o,--out", out, "folder for " + written)->capture_default_str();
  verb.add_option("--map", map, "map document, or a source to import; overrides the deployment's");
  overlays.add_to(verb, ", beside those of the deployment");
  verb.add_option("--log-set", log_words,
                  "an option of the log's source, NAME=VALUE (scan_topic=/front), before those of the deployment; "
                  "`opal plugins` lists them; may be repeated")
      ->allow_extra_args(false);
  verb.add_option("--info", info, "SITE.info.json that describes the laser; overrides the deployment's");
}

opal::Deployment LogRunOptions::deployment() const {
  opal::Deployment deployment = opal::read_deployment(config_file(config));
  if (!map.empty()) deployment.map = map;
  deployment.overlays.insert(deployment.overlays.end(), overlays.files.begin(), overlays.files.end());
  if (deployment.map.empty()) throw opal::ConfigError(config + ": /map: missing; name a map here or with --map");
  if (!info.empty()) deployment = opal::with_lasers(std::move(deployment), {opal::read_site_laser(info)});
  return deployment;
}

std::vector<opal::LaserModel> LogRunOptions::lasers_of(const std::vector<opal::LogRecord>& records,
                                                       const std::vector<opal::LaserModel>& described) const {
  return opal::lasers_of_log(records, described, log, info.empty() ? config + ": /sensor" : info);
}

std::vector<opal::Query> LogRunOptions::windows() const {
  if (!queries.empty()) return opal::read_queries(queries);
  const double forever = std::numeric_limits<double>::infinity();
  return {{"run", -forever, forever}};
}
