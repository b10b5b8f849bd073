#pragma once

#include <opal/plugin/plugin_description.hpp>
#include <opal/plugin/plugin_registry.hpp>

#include <memory>
#include <optional>
#include <string>

namespace opal {

/// A class in a file that takes the place of a plugin's type: "acme_scorers.py:Likelihood".
struct ClassSource {
  std::string file;  ///< path, as written
  std::string name;  ///< of the class in it
};

/// What a type's name says; nullopt: it is the name of a plugin's type.
OPAL_EXPORT std::optional<ClassSource> read_class_source(const std::string& type);

/// The type of a plugin that runs classes of this kind: "opal:PythonScorer"; empty: no plugin does.
OPAL_EXPORT std::string host_of(PluginKind kind);

/// The options by which a host makes an object of a class.
/// @param file  of the source, found.
OPAL_EXPORT nlohmann::json host_options(const ClassSource& source, const std::string& file,
                                        const nlohmann::json& options);

/// Makes an object of a class. @throws PluginError naming the class: that it cannot be made and why, or that there is
/// no plugin that runs it.
template <class T>
std::shared_ptr<const T> make_of_class(const PluginRegistry& registry, const ClassSource& source,
                                       const std::string& file, const nlohmann::json& options);

/// What an object of a class says of itself, under the name by which a deployment knows it.
template <class T>
RegisteredType described_object(const T& object, const std::string& name, const std::string& file);

}  // namespace opal
