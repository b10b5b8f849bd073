#include "cli/options/verbs.hpp"

#include <opal/common/error.hpp>

#include <iostream>

// Exit codes: 0 done; 1 the answer is no; 2 wrong use; 3 bad input.
int main(int argc, char** argv) {
  CLI::App app("Opal: where a wheeled robot is in a building, from a LiDAR, odometry and a semantic map", "opal");
  app.require_subcommand(1);
  app.set_version_flag("--version", "opal " OPAL_VERSION);
  int exit_code = 0;
  opal::add_demo_verb(app, exit_code);
  opal::add_map_verb(app, exit_code);
  opal::add_localize_verb(app, exit_code);
  opal::add_track_verb(app, exit_code);
  opal::add_view_verb(app, exit_code);
  opal::add_explain_verb(app, exit_code);
  opal::add_simulate_verb(app, exit_code);
  opal::add_drive_verb(app, exit_code);
  opal::add_serve_verb(app, exit_code);
  opal::add_experiment_verb(app, exit_code);
  opal::add_ab_verb(app, exit_code);
  opal::add_bench_verb(app, exit_code);
  opal::add_calibrate_verb(app, exit_code);
  opal::add_calibration_verb(app, exit_code);
  opal::add_plugins_verb(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const opal::Error& error) {
    std::cerr << "opal: " << error.what() << '\n';
    return 3;
  } catch (const std::exception& error) {
    std::cerr << "opal: " << error.what() << '\n';
    return 3;
  }
  return exit_code;
}
