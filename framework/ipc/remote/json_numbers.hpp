#pragma once

#include <opal/common/geometry.hpp>
#include "common/json/config_object.hpp"

#include <string>
#include <vector>

namespace opal::remote {

/// As many finite numbers as expected. @throws ConfigError
std::vector<double> numbers_in(ConfigObject& object, const std::string& key, std::size_t count);
/// A number that must be there. @throws ConfigError
double number_in(ConfigObject& object, const std::string& key, NumberRange range = {});
Pose2 pose_in(ConfigObject& object, const std::string& key);

/// An object with one key, as in events: `point`, `oriented_point`, `segment` or `circle`.
Geometry geometry_in(ConfigObject& object);

}  // namespace opal::remote
