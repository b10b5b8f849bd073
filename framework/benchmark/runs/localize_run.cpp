#include "benchmark/runs/localize_run.hpp"

#include "benchmark/runs/answer.hpp"
#include "benchmark/runs/pace.hpp"
#include "benchmark/runs/progress_bar.hpp"
#include "benchmark/runs/run_picture.hpp"

#include "common/text_file.hpp"
#include "localization/events/run_events.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal::benchmark {
namespace {

namespace fs = std::filesystem;

void print_errors(const RunRecord& record, const opal::GroundTruth& truth) {
  if (record.rows.empty()) return;
  std::vector<double> errors;
  for (const opal::ResultRow& row : record.rows)
    if (const auto pose = truth.T_map_laser_at(row.stamp_s)) errors.push_back(distance_m(*pose, row.T_map_laser));
  if (errors.empty()) return;
  const double last = errors.back();
  std::ranges::sort(errors);
  fmt::print("error against the recorded truth: {:.3f} m now, median {:.3f} m, worst {:.3f} m over {} scans\n", last,
             errors[errors.size() / 2], errors.back(), errors.size());
}

/// Scans and odometry were compared, but not in turns.
bool tells_distances_only(const std::vector<opal::SensorFinding>& findings) {
  using Subject = opal::SensorFinding::Subject;
  const auto tells = [&](Subject subject) {
    return std::ranges::any_of(findings, [&](const auto& finding) { return finding.subject == subject; });
  };
  return tells(Subject::odometry_distance) && !tells(Subject::odometry_turn) && !tells(Subject::mirroring);
}

}  // namespace

nlohmann::ordered_json truth_event_of(const opal::GroundTruth& truth, const opal::Query& window,
                                      const opal::LaserModel& laser) {
  std::vector<opal::StampedPose> poses;
  for (const opal::StampedPose& pose : truth.poses())
    if (pose.stamp_s >= window.start_s - 1 && pose.stamp_s <= window.end_s + 1)
      poses.push_back({pose.stamp_s, pose.pose * laser.T_base_laser.inverse()});
  return opal::truth_event(poses);
}

void LocalizeRun::play(const std::vector<opal::LogRecord>& records, const std::vector<opal::Query>& windows,
                       const Playing& playing, const fs::path& out) {
  ProgressBar bar;
  for (std::size_t k = 0; k < windows.size() && !playing.stop.stop_requested(); ++k) {
    Pace pace(playing.speed, playing.stop);
    RunObserver observer;
    bool is_cut = false;
    observer.ready = [&](double stamp_s) {
      is_cut = !pace.wait_for(stamp_s);
      return !is_cut;
    };
    observer.progress = [&](double share) { bar.show((double(k) + share) / double(windows.size())); };
    observer.updated = [&](const RunRecord& so_far) {
      if (first_scan_drawn_ || so_far.last.hypotheses == 0) return;
      draw("first scan", so_far, out / "first_scan");
      first_scan_drawn_ = true;
    };
    opal::ReplayOptions window;
    window.from_s = windows[k].start_s;
    window.to_s = windows[k].end_s;
    opal::Replay replay(records, lasers_, window);
    play_window(replay, windows[k], observer);
    // Half a query would count as a whole one in the results; the events have it.
    if (!is_cut || windows.size() == 1) all_.append(newest_);
    finished_ += is_cut ? 0 : 1;
  }
  unfinished_ = windows.size() - finished_;
}

void LocalizeRun::play_window(opal::Replay& replay, const opal::Query& window, const RunObserver& observer) {
  localizer_.reset();
  events_.write(opal::start_event(window.id));
  if (truth_) events_.write(truth_event_of(*truth_, window, lasers_.front()));
  newest_ = run_log(localizer_, lasers_.front(), replay, window.id, observer);
  for (const auto& [cause, count] : replay.counts()) oddities_[cause] += count;
  answers_.push_back(answer_of(window.id, newest_, localizer_.why(), truth_));
  for (const opal::SensorFinding& finding : localizer_.sensor_findings())
    if (finding.verdict == opal::SensorFinding::Verdict::contradicted) contradictions_.push_back(finding.words);
}

void LocalizeRun::write(const fs::path& out) const {
  opal::write_with((out / "trajectory.tum").string(),
                   [&](std::ostream& file) { opal::write_tum(file, all_.trajectory); });
  opal::write_with((out / "results.csv").string(), [&](std::ostream& file) { opal::write_results(file, all_.rows); });
  draw("at the end", newest_, out / "picture");
}

void LocalizeRun::print() const {
  if (answers_.size() > 1) {
    fmt::print("{}\n", summary_of(answers_));
    for (const WindowAnswer& answer : answers_) fmt::print("{}\n", line_of(answer));
  } else if (!answers_.empty()) {
    fmt::print("{}\n", localized_text(answers_.front()));
    print_answer(localizer_, all_.last, answers_.front().why);
    if (doubts_map(answers_.front()))
      fmt::print("hint: is this the map of this building, and of the storey that was driven on?\n");
  }
  for (const opal::SensorFinding& finding : localizer_.sensor_findings()) fmt::print("sensor: {}\n", finding.words);
  if (tells_distances_only(localizer_.sensor_findings()))
    fmt::print("sensor: the drive turns too little to tell whether the beams turn counter-clockwise as described\n");
  for (const std::string& words : contradictions_) fmt::print("the sensor description is wrong: {}\n", words);
  for (const auto& [cause, count] : oddities_) fmt::print("log: {}: {} times\n", cause, count);
  if (truth_) print_errors(all_, *truth_);
}

void LocalizeRun::draw(const std::string& moment, const RunRecord& record, const fs::path& without_extension) const {
  opal::DrawingScene scene = scene_of(localizer_, lasers_.front(), record);
  if (truth_) add_truth(scene, truth_->poses(), lasers_.front());
  scene.title = log_ + ": " + moment;
  opal::write_svg(scene, without_extension.string() + ".svg");
  opal::write_png(scene, without_extension.string() + ".png");
}

}  // namespace opal::benchmark
