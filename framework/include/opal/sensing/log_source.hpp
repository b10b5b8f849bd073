#pragma once

#include <opal/common/export.hpp>
#include <opal/sensing/log_contents.hpp>
#include <opal/sensing/pose_hint.hpp>
#include <opal/sensing/scan.hpp>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace opal {

/// One pose of the wheel odometry.
struct OdometryRecord {
  double stamp_s = 0;  ///< by the clock of the log
  Pose2 T_odom_base;   ///< the pose since the start of odometry, which drifts
};
/// A static transform that the log itself states, e.g. from tf_static.
struct MountRecord {
  std::string parent;    ///< name of the frame in which the pose is given
  std::string child;     ///< name of the frame that is placed, a laser perhaps
  Pose2 T_parent_child;  ///< where the child's frame lies in the parent's
};
/// Somebody said where the robot is.
struct HintRecord {
  double stamp_s = 0;  ///< by the clock of the log
  PoseHint hint;       ///< frame `map`
};
/// Somebody asked to forget all that was seen before.
struct ForgetRecord {};
/// What a log may hold; everything else in it is passed over.
using LogRecord = std::variant<OdometryRecord, RawScan, MountRecord, HintRecord, ForgetRecord>;

/// Walks one recorded log in file order.
class OPAL_EXPORT LogReader {
 public:
  virtual ~LogReader();
  /// @return the next readable record, or nullopt at the end. Damaged records are skipped and counted.
  virtual std::optional<LogRecord> next() = 0;
  /// What was skipped, by cause ("malformed line", "truncated last line"); empty for a clean log.
  virtual std::map<std::string, int> defects() const = 0;
  /// Share of the file already walked, in [0, 1]; for progress bars.
  virtual double progress() const = 0;
};

/// Opens one format of recorded logs.
class OPAL_EXPORT LogSource {
 public:
  virtual ~LogSource();
  /// True if the file looks like this format (by name and first bytes); must not throw.
  virtual bool recognizes(const std::string& path) const = 0;
  /// @throws LogError if the file cannot be opened or is no such log.
  virtual std::unique_ptr<LogReader> open(const std::string& path) const = 0;
  /// The same for the lasers of a deployment: with the slices of point clouds that they describe. Unless a source knows
  /// of point clouds, as `open`.
  virtual std::unique_ptr<LogReader> open_for(const std::string& path, const std::vector<LaserModel>& lasers) const;
  /// What the log holds: all lasers and topics, not only what `open` reads. Unless a source knows more, what the
  /// records tell. @throws LogError as `open` does.
  virtual LogContents contents(const std::string& path) const;
};

/// What the records of a log tell of it, from where its reader stands to its end.
OPAL_EXPORT LogContents contents_of(LogReader& reader);

}  // namespace opal
