#pragma once

#include <opal/sensing/scan.hpp>

#include <nlohmann/json.hpp>

#include <string>

namespace opal::cli {

/// Writes a mount that a drive has told into the first laser of a deployment. A laser with `geometry_from_log` would go
/// on with the mount of the log: its beams are written instead, and the option is taken back.
/// @param document  of the deployment; `sensor` may be a laser or a list of them.
/// @param described  that laser as the deployment describes it. @param used  the same with the log's beams and mount.
/// @param mount  numbers of T_base_laser; what is absent stays that of `used`.
/// @return why nothing was written; empty: it was.
std::string write_mount(nlohmann::ordered_json& document, const LaserModel& described, const LaserModel& used,
                        const nlohmann::ordered_json& mount);

}  // namespace opal::cli
