#pragma once

#include "tests/kit/file_content.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace opal::ab_tests {

/// Two scorers on the recorded demonstration.
nlohmann::json small_experiment();

/// The same with simulated drives, 22 cells.
nlohmann::json experiment_with_drives();

/// An arm whose scorer is tests/ab/faulty. @param after  scores, before it fails.
nlohmann::json faulty_arm(const std::string& how, int after);

/// Writes the document. @return its path.
std::string written(const TemporaryFolder& folder, const nlohmann::json& experiment,
                    const std::string& name = "small.jsonld");

using opal::content_of;

}  // namespace opal::ab_tests
