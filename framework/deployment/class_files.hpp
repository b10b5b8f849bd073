#pragma once

#include <opal/deployment/deployment.hpp>

#include "plugin/class_source.hpp"

#include <functional>
#include <string>
#include <vector>

namespace opal {

/// The files of the classes that a deployment names, each once: what decides its answers beside plugins.
OPAL_EXPORT std::vector<std::string> class_files(const Deployment& deployment);

/// Members of a deployment, each of its classes under another name, and the files of classes that it trusts as well.
/// @param type_of  the name of a class as a type: "acme_scorers.py:Likelihood".
OPAL_EXPORT nlohmann::json with_classes_named(nlohmann::json configuration,
                                              const std::function<std::string(const ClassSource&)>& type_of);

/// Members of a deployment that stand in another document, with the files of classes found beside that one.
OPAL_EXPORT nlohmann::json with_classes_beside(nlohmann::json configuration, const std::string& document);

}  // namespace opal
