#include "cli/track/track_output.hpp"

#include <opal/common/quantile.hpp>

#include "benchmark/runs/run_picture.hpp"

#include "common/phrases.hpp"
#include "common/text_file.hpp"
#include "drawing/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <numeric>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;

nlohmann::ordered_json to_json(const TrackErrors& errors) {
  return {{"scans", errors.scans}, {"max_m", errors.max_m}, {"p95_m", errors.p95_m}, {"median_m", errors.median_m}};
}

void print(const std::string& what, const TrackErrors& errors) {
  fmt::print("{:<26} {:5} scans: median {:.3f} m, 95 % {:.3f} m, worst {:.3f} m\n", what, errors.scans, errors.median_m,
             errors.p95_m, errors.max_m);
}

std::vector<ResultRow> laser_rows(const std::string& id, const std::vector<StampedPose>& T_map_base,
                                  const Pose2& T_base_laser) {
  std::vector<ResultRow> rows;
  for (const StampedPose& pose : T_map_base)
    rows.push_back({id, pose.stamp_s, pose.pose * T_base_laser, Status::localized});
  return rows;
}

/// Walls that are not where the map has them, beside the same walls where they are.
DrawingScene deviation_scene(std::shared_ptr<const SemanticMap> map, const MapBelief& belief,
                             const std::vector<Deviation>& deviations) {
  DrawingScene scene;
  scene.title = map->name() + ": where the building differs from its map";
  std::size_t moved = 0, absent = 0;
  for (const Deviation& d : deviations) {
    moved += d.verdict == DeviationVerdict::moved;
    absent += d.verdict == DeviationVerdict::probably_absent;
    if (d.verdict == DeviationVerdict::as_mapped) continue;
    for (MapFeatureNumber number : map->object(map->feature(d.feature).object).features) {
      const Geometry& mapped = map->feature(number).geometry;
      if (const auto* face = std::get_if<Segment>(&mapped); face && d.verdict == DeviationVerdict::probably_absent)
        scene.contradictions.push_back({face->begin, face->end});
      else if (d.verdict == DeviationVerdict::moved && belief[number].observations > 0)
        scene.local_features.push_back({corrected(mapped, belief[number]), DrawingScene::Perception::matched});
    }
  }
  scene.map = std::move(map);
  scene.matched_words = "moved: where the drive sees it";
  scene.contradiction_words = "probably absent: beams pass through it";
  scene.notes = {count_of(moved, "object") + (moved == 1 ? " stands" : " stand") + " elsewhere",
                 count_of(absent, "object") + (absent == 1 ? " is" : " are") + " probably absent"};
  return scene;
}

}  // namespace

TrackOutput::TrackOutput(fs::path folder, const LaserModel& laser, std::shared_ptr<const SemanticMap> map,
                         std::optional<GroundTruth> truth)
    : folder_(std::move(folder)), laser_(laser), map_(std::move(map)), truth_(std::move(truth)) {}

void TrackOutput::add(const TrackedWindow& window) {
  rows_.insert(rows_.end(), window.rows.begin(), window.rows.end());
  trajectory_.insert(trajectory_.end(), window.trajectory.begin(), window.trajectory.end());
  update_cpu_ms_.insert(update_cpu_ms_.end(), window.update_cpu_ms.begin(), window.update_cpu_ms.end());
  nlohmann::ordered_json summary = {{"window", window.id}, {"lost", window.last.lost}};
  double worst_m = 0;
  if (truth_) {
    const TrackErrors tracked = errors_of(window.rows, *truth_), driven = errors_of(window.dead_reckoned, *truth_);
    print(window.id, tracked);
    print("  odometry alone", driven);
    summary["tracked"] = to_json(tracked);
    summary["odometry"] = to_json(driven);
    worst_m = tracked.max_m;
  }
  windows_.push_back(std::move(summary));
  if (worst_m <= worst_m_) return;
  worst_m_ = worst_m;
  worst_ = window;
}

void TrackOutput::write() const {
  write_with(file("trajectory.tum"), [&](std::ostream& out) { write_tum(out, trajectory_); });
  write_with(file("results.csv"), [&](std::ostream& out) { write_results(out, rows_); });
  std::vector<double> cpu = update_cpu_ms_;
  std::sort(cpu.begin(), cpu.end());
  const double mean =
      std::accumulate(cpu.begin(), cpu.end(), 0.0) / std::max<double>(1, static_cast<double>(cpu.size()));
  const double p99_ms = quantile_of(cpu, 0.99).value_or(0);
  const nlohmann::ordered_json summary = {{"updates", cpu.size()},
                                          {"cpu_ms_mean", mean},
                                          {"cpu_ms_p99", p99_ms},
                                          {"cpu_ms_max", cpu.empty() ? 0 : cpu.back()},
                                          {"windows", windows_}};
  write_text(file("summary.json"), summary.dump(2) + '\n');
  fmt::print("CPU per update: mean {:.2f} ms, 99 % {:.2f} ms over {} updates\n", mean, p99_ms, cpu.size());
  DrawingScene scene;
  scene.title = worst_.id + (truth_ ? ", the window tracked worst" : "");
  scene.map = map_;
  scene.scan_points = worst_.last_points;
  for (const StampedPose& pose : worst_.trajectory) scene.trajectory.push_back(pose.pose.position());
  if (truth_) benchmark::add_truth(scene, truth_->poses(), laser_);
  write_svg(scene, (folder_ / "picture.svg").string());
  write_png(scene, (folder_ / "picture.png").string());
}

void TrackOutput::write_deviations(const MapBelief& belief) const {
  const std::vector<Deviation> deviations = deviations_of(*map_, belief);
  write_text(file("deviations.json"), to_json(*map_, deviations).dump(1) + '\n');
  write_text(file("deviations.txt"), to_table(deviations));
  write_svg(deviation_scene(map_, belief, deviations), (folder_ / "deviations.svg").string());
  const auto count = [&](DeviationVerdict verdict) {
    return std::count_if(deviations.begin(), deviations.end(), [&](const auto& d) { return d.verdict == verdict; });
  };
  std::cout << "mapped objects that were recognized: " << deviations.size()
            << "; moved: " << count(DeviationVerdict::moved)
            << "; probably absent: " << count(DeviationVerdict::probably_absent)
            << "; the list: " << (folder_ / "deviations.txt").string() << '\n';
}

void TrackOutput::write_smoothed(const TrackedWindow& window, const SmoothedTrack& smoothed) const {
  const auto trajectory = corrected_trajectory(window.trajectory, window.track, smoothed);
  std::string csv = "timestamp,x,y,theta,is_scan\n";
  const auto rows = laser_rows(window.id, trajectory, laser_.T_base_laser);
  for (const ResultRow& row : rows)
    csv += fmt::format("{:.6f},{:.5f},{:.5f},{:.6f},1\n", row.stamp_s, row.T_map_laser.x(), row.T_map_laser.y(),
                       row.T_map_laser.heading_rad());
  write_text(file("truth.csv"), csv);
  if (truth_) print("smoothed", errors_of(rows, *truth_));
}

}  // namespace opal::cli
