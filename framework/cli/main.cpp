#include "cli/options/exit_code.hpp"
#include "cli/options/overwritten_inputs.hpp"
#include "cli/options/verbs.hpp"
#include "cli/options/wrong_use.hpp"

#include "common/phrases.hpp"
#include "common/write_error.hpp"
#include "output/output_folder.hpp"

#include <signal.h>

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <new>
#include <string>
#include <vector>

namespace opal::cli {
namespace {

int fail(ExitCode code, const std::string& message) {
  std::cerr << "opal: " << message << '\n';
  return code;
}

/// Whoever pipes what is printed into a file wants to know that it is whole.
int with_output_written(int exit_code) {
  errno = 0;
  const bool is_written = std::cout.flush() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (is_written) return exit_code;
  return fail(kNotWritten, WriteError("standard output", errno).what());
}

void add_verbs(CLI::App& app, int& exit_code) {
  add_demo_verb(app, exit_code);
  add_map_verb(app, exit_code);
  add_info_verb(app, exit_code);
  add_localize_verb(app, exit_code);
  add_track_verb(app, exit_code);
  add_learn_verb(app, exit_code);
  add_view_verb(app, exit_code);
  add_explain_verb(app, exit_code);
  add_simulate_verb(app, exit_code);
  add_drive_verb(app, exit_code);
  add_serve_verb(app, exit_code);
  add_ros2_verb(app, exit_code);
  add_experiment_verb(app, exit_code);
  add_ab_verb(app, exit_code);
  add_bench_verb(app, exit_code);
  add_calibrate_verb(app, exit_code);
  add_calibration_verb(app, exit_code);
  add_plugins_verb(app, exit_code);
}

/// The word that stands where a command is expected and is none, with the commands that there are; empty if all is
/// well.
std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  for (const std::string& word : words) {
    if (word.starts_with('-') || command->get_require_subcommand_min() == 0) return "";
    const CLI::App* next = nullptr;
    const std::vector<const CLI::App*> all = command->get_subcommands([](const CLI::App*) { return true; });
    for (const CLI::App* known : all)
      if (known->get_name() == word) next = known;
    if (next == nullptr)
      return "'" + word + "': no command of " + command->get_name() +
             ", expected one of: " + listed_by(all, [](const CLI::App* known) { return known->get_name(); }) +
             "; --help explains them";
    command = next;
  }
  return "";
}

int run(CLI::App& app, int argc, char** argv, const int& exit_code) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kWrongUse;
  } catch (const WriteError& error) {
    return fail(kNotWritten, error.what());
  } catch (const FolderInUse& error) {
    return fail(kInUse, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kBadInput, "out of memory, expected a smaller map or log, or a machine with more memory");
  } catch (const std::exception& error) {
    return fail(kBadInput, error.what());
  }
  return exit_code;
}

int program(int argc, char** argv) {
  signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is an error of the file that reaches it
  CLI::App app("Opal: where a wheeled robot is in a building, from a LiDAR, odometry and a semantic map", "opal");
  app.require_subcommand(1);
  app.failure_message([&app](const CLI::App*, const CLI::Error& error) { return wrong_use(app, error); });
  app.set_version_flag("--version", "opal " OPAL_VERSION);
  int exit_code = kDone;
  add_verbs(app, exit_code);
  app.parse_complete_callback([&app] { expect_no_input_overwritten(app); });
  if (const std::string unknown = unknown_command(app, {argv + 1, argv + argc}); !unknown.empty())
    return fail(kWrongUse, unknown);
  return with_output_written(run(app, argc, argv, exit_code));
}

}  // namespace

}  // namespace opal::cli

int main(int argc, char** argv) { return opal::cli::program(argc, argv); }
