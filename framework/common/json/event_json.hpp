#pragma once

#include <opal/common/geometry.hpp>

#include <nlohmann/json.hpp>

#include <span>

namespace opal {

/// How geometry is written in events, and in messages between programs: docs/events.md.
OPAL_EXPORT nlohmann::ordered_json pose_json(const Pose2& pose);
/// Adds the member that names the geometry's kind to an object.
OPAL_EXPORT void add_geometry(nlohmann::ordered_json& object, const Geometry& geometry);
/// [x, y, x, y, ...], to the millimetre.
OPAL_EXPORT nlohmann::ordered_json points_json(std::span<const Point> points);

}  // namespace opal
