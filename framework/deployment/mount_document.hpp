#pragma once

#include <opal/common/geometry.hpp>

#include <nlohmann/json.hpp>

namespace opal {

/// `T_base_laser` of a sensor's description, as a deployment document has it [m, rad].
inline nlohmann::ordered_json mount_document(const Pose2& T_base_laser) {
  return {{"x_m", T_base_laser.x()}, {"y_m", T_base_laser.y()}, {"heading_rad", T_base_laser.heading_rad()}};
}

}  // namespace opal
