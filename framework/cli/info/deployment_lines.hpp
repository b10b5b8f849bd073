#pragma once

#include <opal/sensing/log_contents.hpp>

#include <nlohmann/json.hpp>

namespace opal::cli {

/// What of a deployment a log tells: `sensor` and `log_sources`. Empty if the log has no laser that is read.
/// @param source  the log source that recognizes the log: "opal:Ros2Bag"
nlohmann::ordered_json deployment_lines(const LogContents& contents, const std::string& source);

/// What of these lines is taken, because the log does not tell it; empty: nothing is.
std::string doubt_of_lines(const LogContents& contents);

/// A deployment to go on with: an existing one with these lines in it.
/// @param config  its path, or the name of one that ships. @throws ConfigError if something is wrong with it.
void write_deployment(const nlohmann::ordered_json& lines, const std::string& config, const std::string& out);

}  // namespace opal::cli
