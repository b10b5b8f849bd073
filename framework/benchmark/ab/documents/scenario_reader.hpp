#pragma once

#include "benchmark/ab/documents/experiment.hpp"

#include "common/json/config_object.hpp"

namespace opal::ab {

/// `sites`, `simulated` and `seeds` of an experiment's document. @throws ConfigError as `read_experiment` does.
std::vector<Scenario> read_scenarios(ConfigObject& document, const std::string& file);

/// `name`: letters, digits, '_', '-' and '.', as it becomes part of file names and links.
std::string read_name(ConfigObject& object);

}  // namespace opal::ab
