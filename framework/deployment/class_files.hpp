#pragma once

#include <opal/deployment/deployment.hpp>

#include <string>
#include <vector>

namespace opal {

/// The files of the classes that a deployment names, each once: what decides its answers beside plugins.
OPAL_EXPORT std::vector<std::string> class_files(const Deployment& deployment);

/// Members of a deployment that stand in another document, with the files of classes found beside that one.
OPAL_EXPORT nlohmann::json with_classes_beside(nlohmann::json configuration, const std::string& document);

}  // namespace opal
