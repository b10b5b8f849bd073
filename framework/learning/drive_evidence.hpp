#pragma once

#include "learning/drive_legs.hpp"

#include <opal/localization/localizer.hpp>
#include <opal/sensing/replay.hpp>

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// What one drive says of a map. It does not matter how it started.
struct DriveEvidence {
  std::string map;    ///< name of the map
  std::string drive;  ///< name of the drive: a log, a window of it
  std::vector<VisitEvidence> visits;
  double learned_m = 0;   ///< driven while localizer and tracker agreed [m]
  double left_out_m = 0;  ///< driven along stretches of which nothing was learned [m]
};

/// Watches a drive: the localizer says where the robot is, the tracker of `survey` what it sees of the map there.
class DriveObserver {
 public:
  /// @param parts  of a localizer with a map.
  explicit DriveObserver(const LocalizerParts& parts);
  ~DriveObserver();

  /// In time order.
  void update(const Sample& sample);
  /// What has been said since this was last asked; nothing if no visit has ended since then.
  std::optional<DriveEvidence> take(const std::string& drive);
  /// What the drive has said. The observer must not be used afterwards.
  DriveEvidence finish(const std::string& drive);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// What the rest of a recorded drive says of the map of a localizer.
/// @param progress  is told what share of the log has been played; may be empty.
DriveEvidence observed_drive(const LocalizerParts& parts, Replay& replay, const std::string& drive,
                             const std::function<void(double)>& progress = {});

/// The document of one drive, and back. @throws ConfigError naming file, place, what was found and what was expected.
nlohmann::ordered_json to_json(const DriveEvidence& evidence);
DriveEvidence drive_evidence_from(const nlohmann::json& document, const std::string& file);

}  // namespace opal
