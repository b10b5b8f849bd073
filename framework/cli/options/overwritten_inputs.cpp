#include "cli/options/overwritten_inputs.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool writes(const CLI::Option& option) {
  constexpr std::array<std::string_view, 10> kOutputs{"--out",     "--svg", "--png",      "--record", "--state",
                                                      "--motions", "--csv", "--evidence", "--report", "--html"};
  return is_one_of(kOutputs, option.get_name());
}

/// Whether a command writes documents of the kind that it reads by this option.
bool completes(const CLI::App& command, const CLI::Option& option) {
  constexpr std::array<std::string_view, 3> kCommands{"info", "calibrate", "ros2"};
  constexpr std::array<std::string_view, 2> kDeployments{"CONFIG", "--config"};
  return is_one_of(kCommands, command.get_name()) && is_one_of(kDeployments, option.get_name());
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code absent;
  return fs::is_regular_file(a, absent) && fs::equivalent(a, b, absent);
}

void expect_other_file(const CLI::App& command, const CLI::Option& output) {
  for (const CLI::Option* input : command.get_options()) {
    if (writes(*input) || completes(command, *input)) continue;
    for (const std::string& read : input->results())
      for (const std::string& written : output.results())
        if (is_same_file(written, read))
          throw ConfigError(written + ": is read as " + input->get_name() + ", expected another file for " +
                            output.get_name());
  }
}

}  // namespace

void expect_no_input_overwritten(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* option : command->get_options())
      if (writes(*option)) expect_other_file(*command, *option);
    expect_no_input_overwritten(*command);
  }
}

}  // namespace opal::cli
