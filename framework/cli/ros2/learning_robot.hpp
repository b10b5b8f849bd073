#pragma once

#include "fleet/evidence_outbox.hpp"
#include "learning/live_observer.hpp"
#include "session/stored_maps.hpp"

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Where a robot's evidence goes while it drives.
struct LearningOptions {
  std::string evidence;    ///< a file (.json), written anew after each visit; empty: none
  bool is_pushed = false;  ///< into the map store

  bool any() const { return is_pushed || !evidence.empty(); }
};

/// Learns from a running robot, and keeps what it has learned after each visit. What cannot be kept is told once, and
/// the robot is localized all the same.
class LearningRobot {
 public:
  /// @param map  that the robot is localized on; if evidence shall be pushed, a version of a map store.
  LearningRobot(const LearningOptions& options, const opal::PluginRegistry& plugins,
                const opal::session::VersionedMap& map);
  /// Ends the visit. It is kept, and sent by the next program that pushes: nobody waits for a server now.
  ~LearningRobot();
  LearningRobot(const LearningRobot&) = delete;
  LearningRobot& operator=(const LearningRobot&) = delete;

  void begin(const opal::LocalizerParts& parts);
  /// Before `begin`: left out.
  void take(const opal::LogRecord& record);

 private:
  void keep(const opal::DriveEvidence& evidence);
  void send();

  LearningOptions options_;
  std::shared_ptr<const opal::MapStore> store_;  ///< null: not pushed
  opal::StoreSource version_;
  std::optional<opal::EvidenceOutbox> outbox_;
  nlohmann::ordered_json said_ = nlohmann::ordered_json::array();
  std::atomic<bool> ends_ = false;
  std::unique_ptr<opal::LiveObserver> observer_;  ///< last: its thread ends before what it uses
};
