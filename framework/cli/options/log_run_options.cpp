#include "cli/options/log_run_options.hpp"

#include "sensing/log_check.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <limits>

namespace opal::cli {

void add_log_words(CLI::App& verb, std::vector<std::string>& words) {
  verb.add_option("--log-set", words,
                  "an option of the log's source, NAME=VALUE (scan_topic=/front), before those of the deployment; "
                  "`opal plugins` lists them; may be repeated")
      ->allow_extra_args(false);
}

void LogRunOptions::add_to(CLI::App& verb, const std::string& written) {
  verb.add_option("CONFIG", config, "deployment document, or the name of one that ships: default, malaga")->required();
  verb.add_option("LOG", log, "recorded log (CARMEN text, .gz too; ROS 2 bag .db3, MCAP, ROS 1 bag)")->required();
  verb.add_option("-o,--out", out, "folder for " + written)->capture_default_str();
  verb.add_option("--map", map, "map document, or a source to import; overrides the deployment's");
  overlays.add_to(verb, ", beside those of the deployment");
  add_log_words(verb, log_words);
  verb.add_option("--info", info, "SITE.info.json that describes the laser; overrides the deployment's");
}

Deployment LogRunOptions::deployment() const {
  Deployment deployment = read_deployment(session::config_file(config));
  if (!map.empty()) deployment.map = map;
  deployment.overlays.insert(deployment.overlays.end(), overlays.files.begin(), overlays.files.end());
  session::expect_map(deployment, config);
  if (!info.empty()) deployment = with_lasers(std::move(deployment), {read_site_laser(info)});
  return deployment;
}

std::vector<LaserModel> LogRunOptions::lasers_of(const std::vector<LogRecord>& records,
                                                 const std::vector<LaserModel>& described) const {
  return lasers_of_log(records, described, log, info.empty() ? config + ": /sensor" : info);
}

std::string LogRunOptions::mount_doubt(const std::vector<LogRecord>& records, const Deployment& described) const {
  const auto is_mount = [](const LogRecord& record) { return std::holds_alternative<MountRecord>(record); };
  const bool is_stated = takes_geometry_from_log(described) && std::any_of(records.begin(), records.end(), is_mount);
  if (described.describes_mount || is_stated) return "";
  return "nothing says where the laser sits on the robot (" + config +
         ": /sensor/T_base_laser): the middle is taken, and every pose is off by the laser's true distance from it";
}

std::vector<Query> LogRunOptions::windows() const {
  if (!queries.empty()) return read_queries(queries);
  const double forever = std::numeric_limits<double>::infinity();
  return {{"run", -forever, forever}};
}

}  // namespace opal::cli
