#include "cli/drive/drive_report.hpp"

#include "benchmark/experiments/kit/order_statistics.hpp"
#include "benchmark/experiments/kit/summary_json.hpp"

#include "common/phrases.hpp"
#include "common/text_file.hpp"
#include "drawing/drawing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace opal::cli {
namespace {

using experiments::kNever;
using experiments::median;
using experiments::number_or_null;

nlohmann::ordered_json collisions_of(const DriveRecord& record) {
  auto collisions = nlohmann::ordered_json::array();
  for (const DriveRecord::Collision& collision : record.collisions) {
    const Pose2& pose = collision.T_map_base;
    const Point touched = anchor_of(collision.touched.what);
    collisions.push_back(
        {{"time_s", collision.stamp_s},
         {"pose", {pose.x(), pose.y(), pose.heading_rad()}},
         {"velocity",
          {collision.velocity.linear_mps.x(), collision.velocity.linear_mps.y(), collision.velocity.turn_radps}},
         {"touched", {touched.x(), touched.y()}},
         {"person", collision.touched.person}});
  }
  return collisions;
}

nlohmann::ordered_json summary_of(const DriveTask& task, const DriveRecord& record) {
  nlohmann::ordered_json run = {{"seed", task.seed},
                                {"start", {task.start.x(), task.start.y(), task.start.heading_rad()}},
                                {"goal", {task.goal.x(), task.goal.y()}},
                                {"reached", record.reached},
                                {"said_so", record.said_so},
                                {"why", nullptr},
                                {"time_s", record.time_s},
                                {"driven_m", record.driven_m},
                                {"off_goal_m", record.off_goal_m},
                                {"collisions", collisions_of(record)},
                                {"localized_after_m", nullptr},
                                {"localized_after_s", nullptr},
                                {"scans", record.scans},
                                {"localized_scans", record.localized_scans},
                                {"falsely_localized_scans", record.falsely_localized_scans}};
  if (!record.why.empty()) run["why"] = record.why;
  if (record.localized_after_m) run["localized_after_m"] = *record.localized_after_m;
  if (record.localized_after_s) run["localized_after_s"] = *record.localized_after_s;
  return run;
}

}  // namespace

void DriveReport::add(const DriveTask& task, const DriveRecord& record) {
  constexpr std::size_t kPictures = 3;
  runs_.push_back(summary_of(task, record));
  reached_ += record.reached;
  collisions_ += record.collisions.size();
  falsely_localized_ += record.falsely_localized_scans > 0;
  localized_ += record.localized_after_m.has_value();
  localized_after_m_.push_back(record.localized_after_m.value_or(kNever));
  if (record.reached) times_s_.push_back(record.time_s);
  fmt::print("seed {}: {} after {:.0f} s and {:.1f} m, {:.2f} m from the goal; ", task.seed,
             drive_ending(record.reached, record.said_so), record.time_s, record.driven_m, record.off_goal_m);
  if (record.localized_after_m)
    fmt::print("localized after {:.1f} m", *record.localized_after_m);
  else
    fmt::print("never localized");
  fmt::print("; {}, {} of {} scans falsely localized{}{}\n", count_of(record.collisions.size(), "collision"),
             record.falsely_localized_scans, record.scans, record.why.empty() ? "" : ": ", record.why);
  std::fflush(stdout);
  if (runs_.size() <= kPictures || !record.reached) draw(task, record);
}

void DriveReport::draw(const DriveTask& task, const DriveRecord& record) const {
  DrawingScene scene;
  scene.map = map_;
  scene.title = map_->name() + ": seed " + std::to_string(task.seed) + (record.reached ? ", reached" : ", not reached");
  scene.unmapped = task.unmapped;
  for (const DriveRecord::Moment& moment : record.moments) {
    scene.truth.push_back(moment.truth.position());
    if (moment.has_pose && moment.status == Status::localized) scene.trajectory.push_back(moment.estimate.position());
  }
  if (!record.moments.empty() && record.moments.back().has_pose)
    scene.hypotheses.push_back({record.moments.back().estimate, 1});
  scene.places = {{task.goal, "goal"}};
  scene.notes.push_back(fmt::format("From ({:.1f}, {:.1f}) to the goal ({:.1f}, {:.1f}): {:.0f} s, {:.1f} m.",
                                    task.start.x(), task.start.y(), task.goal.x(), task.goal.y(), record.time_s,
                                    record.driven_m));
  if (!record.why.empty()) scene.notes.emplace_back("Not reached: " + record.why + ".");
  scene.notes.emplace_back("The estimated trajectory is drawn where it was called localized.");
  const std::string name = (out_ / ("drive_" + std::to_string(task.seed))).string();
  write_svg(scene, name + ".svg");
  write_png(scene, name + ".png");
}

nlohmann::ordered_json DriveReport::totals() const {
  return {{"map", map_->name()},
          {"behaviour", behaviour_},
          {"drives", runs_.size()},
          {"reached", reached_},
          {"localized", localized_},
          {"collisions", collisions_},
          {"drives_falsely_localized", falsely_localized_},
          {"median_localized_after_m", number_or_null(median(localized_after_m_))},
          {"median_time_s", number_or_null(median(times_s_))}};
}

void DriveReport::write() const {
  nlohmann::ordered_json summary = totals();
  nlohmann::ordered_json told = summary;
  for (auto& value : told)
    if (value.is_number_float()) value = std::round(1e3 * value.get<double>()) / 1e3;
  fmt::print("{}\n", told.dump());
  summary["runs"] = runs_;
  write_text((out_ / "summary.json").string(), summary.dump(1) + '\n');
}

}  // namespace opal::cli
