#include "cli/track/track_output.hpp"

#include <opal/common/quantile.hpp>

#include "benchmark/runs/run_picture.hpp"

#include "common/text_file.hpp"
#include "drawing/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <numeric>

namespace {

namespace fs = std::filesystem;

nlohmann::ordered_json to_json(const TrackErrors& errors) {
  return {{"scans", errors.scans}, {"max_m", errors.max_m}, {"p95_m", errors.p95_m}, {"median_m", errors.median_m}};
}

void print(const std::string& what, const TrackErrors& errors) {
  fmt::print("{:<26} {:5} scans: median {:.3f} m, 95 % {:.3f} m, worst {:.3f} m\n", what, errors.scans, errors.median_m,
             errors.p95_m, errors.max_m);
}

std::vector<opal::ResultRow> laser_rows(const std::string& id, const std::vector<opal::StampedPose>& T_map_base,
                                        const opal::Pose2& T_base_laser) {
  std::vector<opal::ResultRow> rows;
  for (const opal::StampedPose& pose : T_map_base)
    rows.push_back({id, pose.stamp_s, pose.pose * T_base_laser, opal::Status::localized});
  return rows;
}

/// Walls that are not where the map has them, beside the same walls where they are.
opal::DrawingScene deviation_scene(std::shared_ptr<const opal::SemanticMap> map, const opal::MapBelief& belief,
                                   const std::vector<opal::Deviation>& deviations) {
  opal::DrawingScene scene;
  scene.title = map->name() + ": where the building differs from its map";
  std::size_t moved = 0, absent = 0;
  for (const opal::Deviation& d : deviations) {
    moved += d.verdict == opal::DeviationVerdict::moved;
    absent += d.verdict == opal::DeviationVerdict::probably_absent;
    if (d.verdict == opal::DeviationVerdict::as_mapped) continue;
    for (opal::MapFeatureNumber number : map->object(map->feature(d.feature).object).features) {
      const opal::Geometry& mapped = map->feature(number).geometry;
      if (const auto* face = std::get_if<opal::Segment>(&mapped);
          face && d.verdict == opal::DeviationVerdict::probably_absent)
        scene.contradictions.push_back({face->begin, face->end});
      else if (d.verdict == opal::DeviationVerdict::moved && belief[number].observations > 0)
        scene.local_features.push_back(
            {opal::corrected(mapped, belief[number]), opal::DrawingScene::Perception::matched});
    }
  }
  scene.map = std::move(map);
  scene.notes = {std::to_string(moved) + " objects stand elsewhere: their faces are drawn where they were perceived",
                 std::to_string(absent) + " objects are probably absent: drawn as contradictions"};
  return scene;
}

}  // namespace

TrackOutput::TrackOutput(fs::path folder, const opal::LaserModel& laser, std::shared_ptr<const opal::SemanticMap> map,
                         std::optional<opal::GroundTruth> truth)
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
  opal::write_with(file("trajectory.tum"), [&](std::ostream& out) { opal::write_tum(out, trajectory_); });
  opal::write_with(file("results.csv"), [&](std::ostream& out) { opal::write_results(out, rows_); });
  std::vector<double> cpu = update_cpu_ms_;
  std::sort(cpu.begin(), cpu.end());
  const double mean =
      std::accumulate(cpu.begin(), cpu.end(), 0.0) / std::max<double>(1, static_cast<double>(cpu.size()));
  const double p99_ms = opal::quantile_of(cpu, 0.99).value_or(0);
  const nlohmann::ordered_json summary = {{"updates", cpu.size()},
                                          {"cpu_ms_mean", mean},
                                          {"cpu_ms_p99", p99_ms},
                                          {"cpu_ms_max", cpu.empty() ? 0 : cpu.back()},
                                          {"windows", windows_}};
  opal::write_text(file("summary.json"), summary.dump(2) + '\n');
  fmt::print("CPU per update: mean {:.2f} ms, 99 % {:.2f} ms over {} updates\n", mean, p99_ms, cpu.size());
  opal::DrawingScene scene;
  scene.title = worst_.id + (truth_ ? ", the window tracked worst" : "");
  scene.map = map_;
  scene.scan_points = worst_.last_points;
  for (const opal::StampedPose& pose : worst_.trajectory) scene.trajectory.push_back(pose.pose.position());
  if (truth_) opal::benchmark::add_truth(scene, truth_->poses(), laser_);
  opal::write_svg(scene, (folder_ / "picture.svg").string());
  opal::write_png(scene, (folder_ / "picture.png").string());
}

void TrackOutput::write_deviations(const opal::MapBelief& belief) const {
  const std::vector<opal::Deviation> deviations = opal::deviations_of(*map_, belief);
  opal::write_text(file("deviations.json"), opal::to_json(*map_, deviations).dump(1) + '\n');
  opal::write_text(file("deviations.txt"), opal::to_table(deviations));
  opal::write_svg(deviation_scene(map_, belief, deviations), (folder_ / "deviations.svg").string());
  const auto count = [&](opal::DeviationVerdict verdict) {
    return std::count_if(deviations.begin(), deviations.end(), [&](const auto& d) { return d.verdict == verdict; });
  };
  std::cout << "of " << deviations.size() << " mapped objects that were recognized, "
            << count(opal::DeviationVerdict::moved) << " stand elsewhere, "
            << count(opal::DeviationVerdict::probably_absent)
            << " are probably absent: " << (folder_ / "deviations.txt").string() << '\n';
}

void TrackOutput::write_smoothed(const TrackedWindow& window, const opal::SmoothedTrack& smoothed) const {
  const auto trajectory = opal::corrected_trajectory(window.trajectory, window.track, smoothed);
  std::string csv = "timestamp,x,y,theta,is_scan\n";
  const auto rows = laser_rows(window.id, trajectory, laser_.T_base_laser);
  for (const opal::ResultRow& row : rows)
    csv += fmt::format("{:.6f},{:.5f},{:.5f},{:.6f},1\n", row.stamp_s, row.T_map_laser.x(), row.T_map_laser.y(),
                       row.T_map_laser.heading_rad());
  opal::write_text(file("truth.csv"), csv);
  if (truth_) print("smoothed", errors_of(rows, *truth_));
}
