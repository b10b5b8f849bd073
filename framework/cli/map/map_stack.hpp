#pragma once

#include "map_tools/map_stack.hpp"

#include <opal/map/map_importer.hpp>
#include <opal/plugin/plugin_registry.hpp>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace opal::cli {

/// `opal map stack`: several storeys become one map.
void add_map_stack(CLI::App& map, int& exit_code);

/// The options of every verb that lays storeys side by side.
struct StackVerbOptions {
  StackOptions stack;
  std::string connections;
  std::vector<std::string> without;  ///< names of storeys of a source

  void add_to(CLI::App& verb);
};

/// Every storey of a source that has several, in one map.
struct ImportedStoreys {
  StackedMap stacked;
  std::vector<StoreyPart> parts;
  std::vector<MapImport> imports;     ///< by part
  std::vector<std::string> left_out;  ///< sentences
};
/// @param options  of the importer, without `storey`.
/// @throws opal::MapError if the source has no storeys, or none of them gives anything.
ImportedStoreys import_storeys(const PluginRegistry& registry, const std::string& source, const nlohmann::json& options,
                               const StackVerbOptions& stack);

/// The map, with connections of a file if one is named; tells what was found.
std::shared_ptr<const SemanticMap> finished(const StackedMap& stacked, const StackVerbOptions& options);
/// "written: FILE, 3 storeys, 1 connection".
std::string stacked_sentence(const std::string& out, const SemanticMap& map);

}  // namespace opal::cli
