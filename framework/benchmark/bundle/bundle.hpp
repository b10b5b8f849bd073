#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace opal::ab {

/// The file that makes a folder a bundle, and its experiment.
inline constexpr const char* kBundleFile = "bundle.json";
inline constexpr const char* kBundledExperiment = "experiment.jsonld";

/// A file of a bundle.
struct BundledFile {
  std::string name;  ///< below the bundle's folder, with '/'
  std::string sha256;
  std::uint64_t bytes = 0;
  bool included = true;  ///< else whoever repeats the experiment has it
};

/// A folder with all that an experiment was computed from, and what came out.
struct Bundle {
  std::string folder;
  std::vector<BundledFile> files;

  std::string path_of(const std::string& name) const { return folder + "/" + name; }
};

/// Reads a bundle and checks every file that is included.
/// @throws ConfigError naming the file, and the place in bundle.json, if a file is missing, or was changed, or is not
/// listed.
Bundle read_bundle(const std::string& folder);

/// Copies a bundle's files into a folder, where nothing that a plugin writes changes the bundle. Files that are not
/// included are linked from where they are found.
/// @param places  folders to search for the files that are not included, by name, size and SHA-256.
/// @throws ConfigError naming the files that are not found, with their SHA-256.
void place_files(const Bundle& bundle, const std::vector<std::string>& places, const std::string& folder);

}  // namespace opal::ab
