#pragma once

#include "cli/track/track_run.hpp"

#include "survey/deviation_report.hpp"
#include "survey/track_smoothing.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace opal::cli {

/// What `opal track` leaves behind in its folder.
class TrackOutput {
 public:
  TrackOutput(std::filesystem::path folder, const LaserModel& laser, std::shared_ptr<const SemanticMap> map,
              std::optional<GroundTruth> truth);

  /// Adds a window's rows and errors, and prints the errors.
  void add(const TrackedWindow& window);
  /// trajectory.tum, results.csv, summary.json, and the picture of the window that was tracked worst.
  void write() const;
  /// deviations.json, deviations.txt, and the picture deviations.svg.
  void write_deviations(const MapBelief& belief) const;
  /// truth.csv: smoothed poses of the laser, in the format of a site's recorded truth. Prints errors if there is truth.
  void write_smoothed(const TrackedWindow& window, const SmoothedTrack& smoothed) const;

 private:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
  LaserModel laser_;
  std::shared_ptr<const SemanticMap> map_;
  std::optional<GroundTruth> truth_;
  std::vector<ResultRow> rows_;
  std::vector<StampedPose> trajectory_;
  std::vector<double> update_cpu_ms_;
  nlohmann::ordered_json windows_ = nlohmann::ordered_json::array();
  TrackedWindow worst_;
  double worst_m_ = -1;
};

}  // namespace opal::cli
