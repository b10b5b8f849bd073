#pragma once

#include <opal/common/error.hpp>
#include <opal/plugin/registrar.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace opal {

/// The interface that a type implements.
enum class PluginKind {
  feature_detector,   ///< opal::FeatureDetector
  pattern_template,   ///< opal::PatternTemplate
  hypothesis_scorer,  ///< opal::HypothesisScorer
  log_source,         ///< opal::LogSource
  map_importer,       ///< opal::MapImporter
  scan_matcher,       ///< opal::ScanMatcher
  map_store           ///< opal::MapStore
};

/// The kind as plugin.jsonld writes it: "FeatureDetector".
OPAL_EXPORT const char* name_of(PluginKind kind);

/// One option of a type.
struct OptionInfo {
  std::string name;              ///< as configurations give it: "min_points"
  std::string type;              ///< "number", "integer", "boolean", "string", "object" (of texts)
  std::string unit;              ///< "m", "rad", "s"; empty: dimensionless
  nlohmann::json default_value;  ///< null: it may stay without a value
  nlohmann::json minimum;        ///< null: none
  nlohmann::json maximum;        ///< null: none
  std::string description;       ///< a sentence for people
};

/// One type as plugin.jsonld promises it.
struct DescribedType {
  TypeInfo info;                                   ///< name, and the feature types that it works on
  PluginKind kind = PluginKind::feature_detector;  ///< its interface
  std::string description;                         ///< a sentence for people
  std::vector<OptionInfo> options;                 ///< in the order of the document
  /// A pattern template that runs only where the map's patterns or the deployment name it.
  bool on_request = false;
};

/// The description that stands beside every plugin: known, and checked, before any code of the plugin runs.
/// docs/write_a_plugin.md gives the format.
struct PluginDescription {
  std::string name;                                  ///< of the plugin
  std::string version;                               ///< of the plugin; free text
  std::vector<DescribedType> types;                  ///< in the order of the document
  std::map<std::string, std::string> prefixes = {};  ///< of names in it, with their IRIs
  std::string sha256 = {};                           ///< of the document's file as it was read; empty: none was
};

/// Strict: unknown keys, missing keys, names given twice and defaults out of range are errors.
/// @throws PluginError "FILE: POINTER: what was found, expected what".
OPAL_EXPORT PluginDescription read_plugin_description(const std::string& path);
/// The same for a document that has been read before.
/// @param document  the whole plugin.jsonld.
/// @param file      how messages name the document.
OPAL_EXPORT PluginDescription parse_plugin_description(const nlohmann::json& document, const std::string& file);

/// "an integer from 2 to 1000", "a number >= 0 [m]": what the option accepts, in words.
OPAL_EXPORT std::string accepted_values(const OptionInfo& option);

/// Checks options against their description and fills in the defaults. Numbers come out as floating point
/// where the description says "number".
/// @param type_name  how messages name the type.
/// @param described  all options that the type has.
/// @param given      an object: names and values.
/// @throws PluginError "TYPE: option NAME: what was found, expected what".
OPAL_EXPORT nlohmann::json complete_options(const std::string& type_name, const std::vector<OptionInfo>& described,
                                            const nlohmann::json& given);

/// Options as a person writes them on a command line, each "NAME=VALUE", or "NAME.KEY=TEXT" for an entry of an object.
/// Only their types are checked here: `complete_options` does the rest.
/// @throws PluginError "TYPE: option NAME: ...".
OPAL_EXPORT nlohmann::json parse_options(const std::string& type_name, const std::vector<OptionInfo>& described,
                                         const std::vector<std::string>& words);

}  // namespace opal
