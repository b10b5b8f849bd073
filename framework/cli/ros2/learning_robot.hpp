#pragma once

#include "fleet/evidence_outbox.hpp"
#include "learning/live_observer.hpp"
#include "session/stored_maps.hpp"

#include <atomic>
#include <memory>
#include <optional>
#include <string>

namespace opal::cli {

/// Where a robot's evidence goes while it drives.
struct LearningOptions {
  std::string evidence;    ///< a file (.json), written anew after every ten visits; empty: none
  bool is_pushed = false;  ///< into the map store

  bool any() const { return is_pushed || !evidence.empty(); }
};

/// Learns from a running robot, and keeps what it has learned, ten visits at a time. What cannot be kept is told once,
/// and the robot is localized all the same.
class LearningRobot {
 public:
  /// @param map  that the robot is localized on; if evidence shall be pushed, a version of a map store.
  LearningRobot(const LearningOptions& options, const PluginRegistry& plugins, const session::VersionedMap& map);
  /// Ends the visit. It is kept, and sent by the next program that pushes: nobody waits for a server now.
  ~LearningRobot();
  LearningRobot(const LearningRobot&) = delete;
  LearningRobot& operator=(const LearningRobot&) = delete;

  void begin(const LocalizerParts& parts);
  /// Before `begin`: left out.
  void take(const LogRecord& record);

 private:
  void keep(const DriveEvidence& evidence);
  void send();

  LearningOptions options_;
  std::shared_ptr<const MapStore> store_;  ///< null: not pushed
  StoreSource version_;
  std::optional<EvidenceOutbox> outbox_;
  nlohmann::ordered_json said_ = nlohmann::ordered_json::array();
  std::atomic<bool> ends_ = false;
  std::unique_ptr<LiveObserver> observer_;  ///< last: its thread ends before what it uses
};

}  // namespace opal::cli
