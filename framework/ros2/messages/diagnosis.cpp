#include "ros2/messages/diagnosis.hpp"

#include "common/phrases.hpp"

#include <fmt/format.h>

#include <cmath>

namespace opal::ros2 {
namespace {

// Two computers whose clocks differ by more disagree about every transform.
constexpr double kClockDifferenceS = 1;
constexpr double kSilenceS = 2;

DiagnosisLevel level_of(Status status) {
  if (status == Status::localized) return DiagnosisLevel::ok;
  return status == Status::lost ? DiagnosisLevel::error : DiagnosisLevel::warn;
}

Diagnosis localization(const LiveAnswer& answer, const NodeState& state) {
  Diagnosis diagnosis{DiagnosisLevel::warn, "opal: localization", "", {}};
  if (answer.number == 0) {
    diagnosis.message = state.waits_for.empty() ? "no scan yet" : "waits for " + state.waits_for;
    return diagnosis;
  }
  const PoseEstimate& estimate = answer.estimate;
  diagnosis.level = level_of(estimate.status);
  diagnosis.message = std::string(name_of(estimate.status)) + (answer.why.empty() ? "" : ": " + answer.why);
  diagnosis.values = {{"status", name_of(estimate.status)},
                      {"probability", fmt::format("{:.3f}", estimate.probability)},
                      {"hypotheses", std::to_string(estimate.hypotheses)},
                      {"stamp", fmt::format("{:.3f}", answer.stamp_s)},
                      {"latency_ms", fmt::format("{:.1f}", 1e3 * answer.latency_s)}};
  if (!estimate.has_pose) return diagnosis;
  diagnosis.values.emplace_back("x_m", fmt::format("{:.3f}", estimate.T_map_base.x()));
  diagnosis.values.emplace_back("y_m", fmt::format("{:.3f}", estimate.T_map_base.y()));
  diagnosis.values.emplace_back("heading_rad", fmt::format("{:.4f}", estimate.T_map_base.heading_rad()));
  if (estimate.place.storey.empty()) return diagnosis;
  diagnosis.values.emplace_back("building", estimate.place.building);
  diagnosis.values.emplace_back("storey", estimate.place.storey);
  diagnosis.values.emplace_back("storey_x_m", fmt::format("{:.3f}", estimate.place.T_storey_base.x()));
  diagnosis.values.emplace_back("storey_y_m", fmt::format("{:.3f}", estimate.place.T_storey_base.y()));
  return diagnosis;
}

Diagnosis connections(const NodeState& state) {
  Diagnosis diagnosis{DiagnosisLevel::ok, "opal: connections", "all that is needed is received", {}};
  if (!state.complaints.empty() || !state.waits_for.empty()) {
    diagnosis.level = DiagnosisLevel::error;
    diagnosis.message = state.complaints.empty() ? "waits for " + state.waits_for : listed(state.complaints);
  }
  for (const auto& [topic, rate_hz] : state.rates_hz)
    diagnosis.values.emplace_back(topic, fmt::format("{:.1f} Hz", rate_hz));
  for (const auto& [cause, times] : state.odd_counts) diagnosis.values.emplace_back(cause, std::to_string(times));
  return diagnosis;
}

Diagnosis clock(const LiveAnswer& answer, double now_s) {
  Diagnosis diagnosis{DiagnosisLevel::ok, "opal: clock", "scans are stamped by this clock", {}};
  const double age_s = now_s - answer.stamp_s;
  diagnosis.values = {{"newest_scan_age_s", fmt::format("{:.3f}", age_s)}};
  const std::string complaint = clock_complaint(answer, now_s);
  if (complaint.empty()) return diagnosis;
  diagnosis.level = age_s < 0 ? DiagnosisLevel::error : DiagnosisLevel::warn;
  diagnosis.message = complaint;
  return diagnosis;
}

DiagnosisLevel level_of(HealthFinding::Level level) {
  if (level == HealthFinding::Level::fine) return DiagnosisLevel::ok;
  return level == HealthFinding::Level::doubtful ? DiagnosisLevel::warn : DiagnosisLevel::error;
}

}  // namespace

std::string clock_complaint(const LiveAnswer& answer, double now_s) {
  const double age_s = now_s - answer.stamp_s;
  if (answer.number == 0 || !std::isfinite(age_s)) return "";
  if (age_s < -kClockDifferenceS)
    return fmt::format("the newest scan is stamped {:.1f} s in the future: are the clocks of two computers apart?",
                       -age_s);
  if (age_s > kSilenceS)
    return fmt::format("the newest scan is {:.1f} s old: the laser is silent, or clocks of two computers are apart",
                       age_s);
  return "";
}

std::vector<std::string> health_complaints(const LiveAnswer& answer) {
  std::vector<std::string> words;
  for (const HealthFinding& finding : answer.health)
    if (answer.number == 0 || (finding.subject == "clock" && finding.level == HealthFinding::Level::bad))
      words.push_back(finding.words);
  return words;
}

std::string status_words(const LiveAnswer& answer) {
  const PoseEstimate& estimate = answer.estimate;
  const std::string name = name_of(estimate.status);
  if (estimate.status != Status::localized) return name + (answer.why.empty() ? "" : ": " + answer.why);
  const Pose2& pose = estimate.T_map_base;
  return name +
         fmt::format(" at x {:.2f} m, y {:.2f} m, heading {:.1f} deg", pose.x(), pose.y(), degrees(pose.heading_rad()));
}

std::vector<Diagnosis> diagnoses_of(const LiveAnswer& answer, const NodeState& state, double now_s) {
  std::vector<Diagnosis> diagnoses{localization(answer, state), connections(state)};
  if (answer.number > 0 && std::isfinite(now_s)) diagnoses.push_back(clock(answer, now_s));
  for (const HealthFinding& finding : answer.health)
    diagnoses.push_back({level_of(finding.level), "opal: " + finding.subject, finding.words, {}});
  return diagnoses;
}

}  // namespace opal::ros2
