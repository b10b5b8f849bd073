#pragma once

#include <nlohmann/json.hpp>

#include <string>

/// What a golden file says. With OPAL_UPDATE_GOLDEN in the environment, it says `found` from now on.
/// @param name  of the file, from the folder of the replays.
nlohmann::ordered_json golden_file(const std::string& name, const std::string& found);
