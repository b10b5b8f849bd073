#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/verbs.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include "ipc/remote/localization_server.hpp"

#include <condition_variable>
#include <iostream>
#include <mutex>

namespace opal::cli {
namespace {

using remote::LocalizationServer;

struct ServeOptions {
  std::string config, map;
  int port = LocalizationServer::kUsualPort;
};

int serve(const ServeOptions& options) {
  Deployment deployment = read_deployment(session::config_file(options.config));
  if (!options.map.empty()) deployment.map = options.map;
  session::expect_map(deployment, options.config);
  const PluginRegistry registry = session::load_plugins(deployment);
  const auto map = session::load_map(registry, deployment);
  build_parts(deployment, registry, map);  // what cannot run is said now, not to the first robot
  const auto localizer_for = [&](const LaserModel& laser) {
    return std::make_unique<Localizer>(build_parts(with_lasers(deployment, {laser}), registry, map));
  };
  const StopSignals signals;  // before the server's threads
  const LocalizationServer server(map, deployment.lasers.front().id, localizer_for, options.port);
  std::cout << "localizes at " << server.address() << " (on this machine only; Ctrl-C ends it)" << std::endl;
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any().wait(lock, signals.token(), [] { return false; });
  return kDone;
}

}  // namespace

void add_serve_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ServeOptions>();
  CLI::App* verb = app.add_subcommand(
      "serve", "localize a robot whose behaviours are another program on this machine: opal drive --localizer");
  verb->add_option("CONFIG", options->config,
                   "deployment document, or the name of one that ships; the laser is the robot's")
      ->required();
  verb->add_option("--map", options->map, "map document, or a source to import, instead of the deployment's");
  verb->add_option("--port", options->port, "0: any free one")->check(in_range(0, 65535))->capture_default_str();
  verb->callback([options, &exit_code] { exit_code = serve(*options); });
}

}  // namespace opal::cli
