#pragma once

#include "benchmark/cells/ab_runner.hpp"

namespace opal::benchmark {

/// Everything that the results of an experiment depend on: its document, the configuration of every arm, versions and
/// digests of program and plugins, and digests of maps and logs.
nlohmann::ordered_json manifest_of(const opal::ab::Experiment& experiment, const std::vector<ArmPlugins>& plugins,
                                   WorldSource& worlds);

/// Of all that an arm is made of: program, plugins and configuration; by arm, as the manifest has it.
std::vector<std::string> arm_digests(const nlohmann::ordered_json& manifest);

}  // namespace opal::benchmark
