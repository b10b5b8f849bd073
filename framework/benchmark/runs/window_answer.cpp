#include "benchmark/runs/window_answer.hpp"

#include <opal/common/quantile.hpp>
#include "report/quantity_text.hpp"
#include "report/status_text.hpp"

namespace opal::benchmark {
namespace {

std::string progress_text(const ReplayProgress& progress) {
  return opal::fixed_text(progress.driven_m, 1) + " m and " + opal::seconds_text(progress.time_s);
}

}  // namespace

WindowAnswer answer_of(const std::string& window, const RunRecord& record, const std::string& why,
                       const std::optional<opal::GroundTruth>& truth) {
  WindowAnswer answer{window, record.whole, record.localized_after, record.last, why, std::nullopt};
  if (!truth || record.rows.empty() || !record.last.has_pose) return answer;
  const opal::ResultRow& row = record.rows.back();
  if (const auto pose = truth->T_map_laser_at(row.stamp_s)) answer.off_m = distance_m(*pose, row.T_map_laser);
  return answer;
}

std::string localized_text(const WindowAnswer& answer) {
  if (!answer.localized_after) return "never localized in " + progress_text(answer.whole);
  const bool is_now = answer.at_end.status == opal::Status::localized;
  return "localized after " + progress_text(*answer.localized_after) + (is_now ? "" : ", but no longer at the end");
}

bool doubts_map(const WindowAnswer& answer) {
  constexpr double kMeets_m = 30;  // a drive of that length meets what tells places apart
  return answer.at_end.status != opal::Status::localized && answer.whole.driven_m > kMeets_m;
}

std::string line_of(const WindowAnswer& answer) {
  const opal::PoseEstimate& end = answer.at_end;
  std::string text = answer.window + ": " + localized_text(answer) + "; at the end " +
                     opal::status_text(name_of(end.status), end.has_pose ? end.probability : 0);
  if (end.has_pose) text += " at " + opal::pose_text(end.T_map_base);
  if (answer.off_m) text += ", " + opal::metres_text(*answer.off_m) + " off the truth";
  return text;
}

std::string summary_of(const std::vector<WindowAnswer>& answers) {
  std::vector<double> driven_m;
  for (const WindowAnswer& answer : answers)
    if (answer.localized_after) driven_m.push_back(answer.localized_after->driven_m);
  std::string text = std::to_string(driven_m.size()) + " of " + std::to_string(answers.size()) + " queries localized";
  const auto middle_m = opal::median_of(driven_m);
  return middle_m ? text + ", after " + opal::fixed_text(*middle_m, 1) + " m (median)" : text;
}

}  // namespace opal::benchmark
