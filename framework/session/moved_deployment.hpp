#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace opal::session {

/// The document of a deployment, for another file: the map, the overlays and the files of classes that it names beside
/// its own file are named as that file finds them.
/// @param from, to  the files; they may lie in one folder, and the document stays as it is.
nlohmann::ordered_json moved_deployment(nlohmann::ordered_json document, const std::string& from,
                                        const std::string& to);

}  // namespace opal::session
