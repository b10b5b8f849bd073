#include "viewer/encoding/row_coder.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace opal {
namespace {

std::unordered_map<HypothesisId, const RecordedHypothesis*> by_id(std::span<const RecordedHypothesis> hypotheses) {
  std::unordered_map<HypothesisId, const RecordedHypothesis*> found;
  for (const RecordedHypothesis& hypothesis : hypotheses) found.emplace(hypothesis.id, &hypothesis);
  return found;
}

}  // namespace

void RowCoder::clear() {
  rows_.clear();
  T_local_base_ = {};
}

void RowCoder::write(std::span<const RecordedHypothesis> hypotheses, const Pose2& T_local_base, RecordText& record) {
  const Pose2 D = T_local_base_.inverse() * T_local_base;
  T_local_base_ = T_local_base;
  write_leave(hypotheses, record);
  const std::size_t carried = rows_.size();
  write_rows(hypotheses, D, record);
  write_enter(hypotheses, carried, record);
}

void RowCoder::write_leave(std::span<const RecordedHypothesis> hypotheses, RecordText& record) {
  const auto alive = by_id(hypotheses);
  std::vector<int> positions;
  for (std::size_t k = rows_.size(); k-- > 0;)
    if (!alive.contains(rows_[k].id)) positions.push_back(static_cast<int>(k));
  if (positions.empty()) return;
  record.key("leave").integers(positions);
  std::erase_if(rows_, [&](const Row& row) { return !alive.contains(row.id); });
}

void RowCoder::write_rows(std::span<const RecordedHypothesis> hypotheses, const Pose2& D, RecordText& record) {
  if (rows_.empty()) return;
  const auto alive = by_id(hypotheses);
  std::vector<Step> steps;
  for (Row& row : rows_) steps.push_back(carry(row, *alive.at(row.id), D));
  record.key("rows").open('[');
  for (const auto member : {&Step::x, &Step::y, &Step::heading, &Step::nat}) {
    record.open('[');
    for (const Step& step : steps) record.integer(step.*member);
    record.close(']');
  }
  record.close(']');
}

void RowCoder::write_enter(std::span<const RecordedHypothesis> hypotheses, std::size_t carried, RecordText& record) {
  if (hypotheses.size() == carried) return;
  std::vector<HypothesisId> known;
  for (const Row& row : rows_) known.push_back(row.id);
  std::sort(known.begin(), known.end());
  record.key("enter").open('[');
  for (const RecordedHypothesis& hypothesis : hypotheses) {
    if (std::binary_search(known.begin(), known.end(), hypothesis.id)) continue;
    const Step step = step_of(hypothesis.T_map_base);
    const long long nat = std::llround(hypothesis.log_likelihood / detail_.unit_nat);
    record.open('[').id(hypothesis.id).integer(step.x).integer(step.y).integer(step.heading).integer(nat);
    record.close(']');
    rows_.push_back({hypothesis.id, pose_of(step), nat});
  }
  record.close(']');
}

RowCoder::Step RowCoder::carry(Row& row, const RecordedHypothesis& now, const Pose2& D) const {
  const Pose2 predicted = row.T_map_base * D;
  Step step = step_of(predicted.inverse() * now.T_map_base);
  const long long nat = std::llround(now.log_likelihood / detail_.unit_nat);
  step.nat = nat - row.nat;
  row = {row.id, predicted * pose_of(step), nat};
  return step;
}

Pose2 RowCoder::pose_of(const Step& step) const {
  return {static_cast<double>(step.x) * detail_.unit_m, static_cast<double>(step.y) * detail_.unit_m,
          static_cast<double>(step.heading) * detail_.unit_rad};
}

RowCoder::Step RowCoder::step_of(const Pose2& pose) const {
  return {std::llround(pose.x() / detail_.unit_m), std::llround(pose.y() / detail_.unit_m),
          std::llround(pose.heading_rad() / detail_.unit_rad), 0};
}

}  // namespace opal
