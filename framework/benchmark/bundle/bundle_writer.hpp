#pragma once

#include "benchmark/ab/records/result_folder.hpp"
#include "benchmark/bundle/bundle.hpp"
#include "benchmark/cells/ab_world.hpp"

namespace opal::ab {

struct BundleOptions {
  std::string folder;             ///< where the bundle is made; must not exist, or be empty
  std::string command;            ///< that made the results
  std::uint64_t largest_bytes{};  ///< larger recordings are named by their SHA-256, and not included
};

/// Makes a bundle of an experiment that is finished: documents with their places in the bundle, whole configurations,
/// classes of Python, plugin folders of arms, maps, recordings, and the results.
/// @throws ConfigError if the folder holds something, WriteError if it cannot be written.
Bundle write_bundle(const Experiment& experiment, const nlohmann::ordered_json& manifest,
                    benchmark::WorldSource& worlds, const ResultFolder& results, const BundleOptions& options);

}  // namespace opal::ab
