#pragma once

#include <opal/localization/localizer.hpp>

#include <memory>
#include <utility>

namespace opal::navigation {

/// All that behaviours know of localization (Hendrikx 2023, 4.4.2: two programs with a query interface). Answers are
/// about the newest scan.
class LocalizationQueries {
 public:
  virtual ~LocalizationQueries() = default;

  /// false: localization is not there at the moment, and what follows is old. A robot then stands still.
  virtual bool answers() const { return true; }
  /// Where the robot is, with status, alternatives and their probabilities.
  virtual PoseEstimate estimate() const = 0;
  /// The newest scan, laser frame, with the odometry of its stamp.
  virtual const Scan& newest_scan() const = 0;
  virtual const Pose2& T_odom_base() const = 0;
  virtual const LaserModel& laser() const = 0;
  /// Seen features that the best hypothesis rests on, in the order in which it took them: its pattern first.
  /// Frame: base_link.
  virtual std::vector<Geometry> pattern() const = 0;
  virtual const MapView& map() const = 0;
};

/// Localization as a robot that has it sees it: takes scans, answers queries.
class Localization : public LocalizationQueries {
 public:
  /// Begins a drive, without any idea of the pose.
  virtual void begin() = 0;
  /// @param scan  as the laser gave it, with its odometry.
  virtual void take(const RawScan& scan) = 0;
  /// Asks for a local map that holds only the pattern of the best hypothesis (Localizer::keep_pattern), before the next
  /// scan is taken.
  virtual void keep_pattern() = 0;
};

/// Localization in the same process.
class LocalizerQueries : public Localization {
 public:
  /// The localizer must outlive this.
  LocalizerQueries(Localizer& localizer, const LaserModel& laser) : localizer_(localizer), laser_(laser) {}

  void begin() override;
  void take(const RawScan& scan) override;
  void keep_pattern() override { keep_pattern_ = true; }

  PoseEstimate estimate() const override { return estimate_; }
  const Scan& newest_scan() const override { return scan_; }
  const Pose2& T_odom_base() const override { return T_odom_base_; }
  const LaserModel& laser() const override { return laser_; }
  std::vector<Geometry> pattern() const override;
  const MapView& map() const override { return localizer_.map(); }

 private:
  Localizer& localizer_;
  LaserModel laser_;
  Scan scan_;
  Pose2 T_odom_base_;
  PoseEstimate estimate_;
  bool keep_pattern_ = false;
};

/// The same with a localizer of its own.
class OwnLocalizerQueries : public LocalizerQueries {
 public:
  /// @param localizer  not null.
  OwnLocalizerQueries(std::unique_ptr<Localizer> localizer, const LaserModel& laser)
      : LocalizerQueries(*localizer, laser), localizer_(std::move(localizer)) {}

 private:
  std::unique_ptr<Localizer> localizer_;
};

/// The pose of three numbers. One that was computed has a sine and cosine of its own, which may differ in the last
/// digit, as those of an angle do from those of the same angle wrapped: all that behaviours see is rounded like this,
/// so that they do the same wherever localization runs.
inline Pose2 of_three_numbers(const Pose2& pose) {
  return {pose.x(), pose.y(), Pose2(pose.position(), pose.heading_rad()).heading_rad()};
}

}  // namespace opal::navigation
