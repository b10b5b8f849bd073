#pragma once

#include <opal/error.hpp>
#include <opal/plugin/registrar.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace opal {

enum class PluginKind { feature_detector, pattern_template, hypothesis_scorer, log_source, map_importer, scan_matcher };

/// One option of a type, from the plugin's plugin.jsonld.
struct OptionInfo {
  std::string name;
  std::string type;         ///< "number", "integer", "boolean", "string"
  std::string unit;         ///< "m", "rad", "s"; empty: dimensionless
  nlohmann::json default_value;
  nlohmann::json minimum;   ///< null: none
  nlohmann::json maximum;   ///< null: none
  std::string description;
};

/// What the application knows of one registered type.
struct RegisteredType {
  TypeInfo info;
  PluginKind kind;
  std::string plugin;       ///< plugin name
  std::string version;
  std::string file;         ///< canonical path of the shared library
  std::string description;
  std::vector<OptionInfo> options;
};

/// The door for plugins (style: metadata is checked before any code of a file runs; a plugin is taken whole or not
/// at all; libraries stay loaded until the process ends). Not thread-safe: load at start-up.
class OPAL_EXPORT PluginRegistry {
 public:
  PluginRegistry();
  ~PluginRegistry();
  PluginRegistry(PluginRegistry&&) noexcept;
  PluginRegistry& operator=(PluginRegistry&&) noexcept;

  /// Loads one library with the description plugin.jsonld that stands beside it (<name>.jsonld).
  /// @throws PluginError naming the file and the cause; the registry is unchanged then.
  void load(const std::string& path);
  /// Loads every *.so in a folder, by name. A refused file does not keep the others out.
  /// @return the refusals, one message each.
  std::vector<std::string> load_all(const std::string& folder);

  /// All types, by name.
  std::vector<RegisteredType> types() const;
  /// @throws PluginError if there is none of that name; the message lists what there is of that kind.
  const RegisteredType& type(const std::string& name) const;
  bool has(const std::string& name) const;

  /// Makes an object. Options are checked against the description (unknown names, types, ranges) and completed
  /// with its defaults first. T is one of the six interfaces.
  /// @throws PluginError naming the type, the option, what was found and what is expected; also for a factory that
  ///         throws or returns null.
  template <class T>
  std::shared_ptr<const T> make(const std::string& name,
                                const nlohmann::json& options = nlohmann::json::object()) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace opal
