#pragma once

#include <opal/plugin/plugin_description.hpp>
#include <opal/plugin/trusted_plugins.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// What the application knows of one registered type.
struct RegisteredType {
  TypeInfo info;                                   ///< name, and the feature types that it works on
  PluginKind kind = PluginKind::feature_detector;  ///< its interface
  std::string plugin;                              ///< plugin name
  std::string version;                             ///< of the plugin
  std::string file;                                ///< canonical path of the shared library
  std::string description;                         ///< a sentence for people
  std::vector<OptionInfo> options;                 ///< in the order of the description
  bool on_request = false;  ///< a pattern template that runs only where the map's patterns or the deployment name it
};

/// The door for plugins. Metadata is checked before any code of a file runs; a plugin is taken whole or not
/// at all; a library that was opened stays loaded until the process ends. Loading is for one thread, at
/// start-up; afterwards the const functions may be called from several.
class OPAL_EXPORT PluginRegistry {
 public:
  /// A registry that knows no types.
  PluginRegistry();
  ~PluginRegistry();
  /// Takes the contents of another registry, which must not be used any more.
  PluginRegistry(PluginRegistry&&) noexcept;
  /// Takes the contents of another registry, which must not be used any more.
  PluginRegistry& operator=(PluginRegistry&&) noexcept;

  /// Loads one library with the description that stands beside it (lines.jsonld beside lines.so).
  /// @throws PluginError naming the file and the cause; the registry is unchanged then.
  void load(const std::string& path);
  /// Takes a plugin at its description's word: its code is opened when something of it is made for the first time, and
  /// what is not needed costs no memory.
  /// @throws PluginError as `load`, but for what only its code tells; `make` throws that then.
  void announce(const std::string& path);
  /// Loads every *.so in a folder, by name. A refused file does not keep the others out.
  /// @return the refusals, one message each.
  /// @throws PluginError if there is no such folder.
  std::vector<std::string> load_all(const std::string& folder);
  /// Announces every *.so in a folder in the same way.
  std::vector<std::string> announce_all(const std::string& folder);

  /// All types, by name.
  std::vector<RegisteredType> types() const;
  /// @throws PluginError if there is none of that name; the message lists what there is.
  const RegisteredType& type(const std::string& name) const;
  /// True if a type of that name was loaded or announced.
  bool has(const std::string& name) const;

  /// The same plugins, of which only trusted ones are made. A digest is computed before code of its file runs: plugins
  /// that were announced, and files of classes, run only if it is as listed. Lists of this registry hold, too.
  /// @param trusted  nullopt: what this registry trusts.
  PluginRegistry trusting(const std::optional<TrustedPlugins>& trusted) const;
  /// True if every list names the plugin of that type; its digest is another matter. @throws PluginError as `type`.
  bool is_listed(const std::string& name) const;
  /// @throws ConfigError naming plugin, file and both digests if `make` would refuse the type's library by a list.
  void expect_trusted(const std::string& name) const;

  /// Makes an object, which may outlive the registry. Options are checked against the description (unknown
  /// names, types, ranges) and completed with its defaults first. T is one of the seven interfaces.
  /// @throws PluginError naming the type, the option, what was found and what is expected; also for a factory
  ///         that throws or returns null, and for an announced plugin that cannot be opened or is not as described.
  /// @throws ConfigError for a library or a file of a class that is not trusted (`trusting`).
  template <class T>
  std::shared_ptr<const T> make(const std::string& name,
                                const nlohmann::json& options = nlohmann::json::object()) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace opal
