#pragma once

#include "common/json/config_object.hpp"
#include "plugin/class_source.hpp"

#include <opal/common/error.hpp>
#include <opal/deployment/deployment.hpp>

#include <memory>
#include <string>
#include <vector>

namespace opal {

/// A part as a deployment asks for it: an object of a plugin's type, or of a class in a file beside the deployment.
/// @param document  path of the deployment.
/// @throws ConfigError naming the place in the deployment, for a class; PluginError for a plugin's type.
template <class T>
std::shared_ptr<const T> make_part(const PartConfig& part, const std::string& document,
                                   const PluginRegistry& registry) {
  const auto source = read_class_source(part.type);
  if (!source) return registry.make<T>(part.type, part.options);
  try {
    return make_of_class<T>(registry, *source, beside(document, source->file), part.options);
  } catch (const PluginError& refusal) {
    throw ConfigError(part.where + ": " + refusal.what());
  }
}

/// Makes an object of a class once, to see that it can be made. @throws ConfigError likewise.
void expect_class(const PartConfig& part, PluginKind kind, const std::string& document, const PluginRegistry& registry);

/// The types that plugins offer, and the classes that a deployment names as detectors and templates.
std::vector<RegisteredType> types_for(const Deployment& deployment, const PluginRegistry& registry);

}  // namespace opal
