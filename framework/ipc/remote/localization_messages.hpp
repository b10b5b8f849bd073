#pragma once

#include <opal/localization/localizer.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace opal::remote {

/// What a robot and the program that localizes it say to each other: docs/drive.md. JSON; metres, radians,
/// seconds; a pose is [x, y, heading]. Whoever reads takes nothing for granted: an unknown key, a value of
/// another type, a number that is not finite, and too many of anything are errors.
constexpr int kProtocol = 1;
constexpr std::size_t kMostBytes = 4u << 20;  ///< of a message, the map apart

/// A drive begins with this laser.
nlohmann::json to_json(const LaserModel& laser);
/// @throws ConfigError naming place, what was found and what was expected, as all that read here.
LaserModel laser_from(const nlohmann::json& json);

/// One scan of a drive, with its odometry.
struct ScanMessage {
  std::string session;
  RawScan scan;
  bool keep_pattern =
      false;  ///< before the scan is taken: the local map is to hold only the pattern of the best hypothesis
};
nlohmann::json to_json(const ScanMessage& message);
ScanMessage scan_from(const nlohmann::json& json);

/// What localization makes of a scan.
struct Answer {
  PoseEstimate estimate;
  std::vector<Geometry> pattern;  ///< frame base_link
};
nlohmann::json to_json(const Answer& answer);
Answer answer_from(const nlohmann::json& json);

}  // namespace opal::remote
