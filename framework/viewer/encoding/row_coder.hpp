#pragma once

#include "viewer/encoding/page_detail.hpp"
#include "viewer/encoding/record_text.hpp"
#include "viewer/reading/run_frame.hpp"

#include <span>
#include <vector>

namespace opal {

/// Codes the poses and likelihoods of hypotheses from frame to frame: `leave`, `rows`, `enter` of a record.
/// It keeps what a reader has decoded and codes the difference to that, so that errors of rounding never add
/// up.
class RowCoder {
 public:
  explicit RowCoder(const PageDetail& detail) : detail_(detail) {}

  /// Forgets all rows: a time line begins.
  void clear();
  /// @param T_local_base  as the record says it
  void write(std::span<const RecordedHypothesis> hypotheses, const Pose2& T_local_base, RecordText& record);

 private:
  struct Row {
    HypothesisId id = {};
    Pose2 T_map_base;   ///< as decoded
    long long nat = 0;  ///< in steps
  };
  struct Step {
    long long x = 0, y = 0, heading = 0, nat = 0;
  };
  void write_leave(std::span<const RecordedHypothesis> hypotheses, RecordText& record);
  void write_rows(std::span<const RecordedHypothesis> hypotheses, const Pose2& D, RecordText& record);
  void write_enter(std::span<const RecordedHypothesis> hypotheses, std::size_t known, RecordText& record);
  Step carry(Row& row, const RecordedHypothesis& now, const Pose2& D) const;
  Pose2 pose_of(const Step& step) const;
  Step step_of(const Pose2& pose) const;

  const PageDetail detail_;
  std::vector<Row> rows_;
  Pose2 T_local_base_;
};

}  // namespace opal
