#pragma once

#include <opal/live/live_localizer.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace opal::ros2 {

/// As diagnostic_msgs/DiagnosticStatus has it.
enum class DiagnosisLevel : std::uint8_t { ok = 0, warn = 1, error = 2, stale = 3 };

/// One line of the robot's health.
struct Diagnosis {
  DiagnosisLevel level = DiagnosisLevel::ok;
  std::string name;                                         ///< "opal: localization"
  std::string message;                                      ///< in words
  std::vector<std::pair<std::string, std::string>> values;  ///< for programs
};

/// What a node knows of itself.
struct NodeState {
  std::string waits_for;                   ///< what is missing to begin; empty: nothing
  std::vector<std::string> complaints;     ///< what does not match between this node and the robot
  std::map<std::string, int> odd_counts;   ///< what was odd, how often
  std::map<std::string, double> rates_hz;  ///< of messages, by topic
};

/// @param answer  with the number 0: there is none yet. @param now_s  by the clock that the scans are stamped with.
std::vector<Diagnosis> diagnoses_of(const LiveAnswer& answer, const NodeState& state, double now_s);

/// That the scans' clock is another one than `now_s` is by; empty: nothing says so.
std::string clock_complaint(const LiveAnswer& answer, double now_s);
/// What of its health keeps a node from answers: all findings before the first answer, then those of clocks that are
/// apart.
std::vector<std::string> health_complaints(const LiveAnswer& answer);
/// The status with its pose, or why it is not localized: a line for a person.
std::string status_words(const LiveAnswer& answer);

}  // namespace opal::ros2
