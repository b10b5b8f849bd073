#pragma once

#include "learning/drive_legs.hpp"

#include <deque>
#include <span>

namespace opal {

/// What a sample shows.
KeyframeView view_of(const Sample& sample);

/// A sample that came while nothing was followed, and what the localizer took for the best pose then.
struct SkippedSample {
  Sample sample;
  std::optional<Pose2> T_map_base;
};

/// Samples between which odometry has moved, of the last metres before a robot was localized.
class SkippedSamples {
 public:
  void add(const Sample& sample, const std::optional<PoseEstimate>& estimate);
  void clear() { samples_.clear(); }
  void append(std::span<const Sample> samples);
  const std::deque<SkippedSample>& all() const { return samples_; }  ///< oldest first

 private:
  void keep(SkippedSample sample);

  std::deque<SkippedSample> samples_;
};

/// One leg while the robot drives it, from where the localizer called the robot localized: the tracker of `survey`
/// follows the map from there, and the localizer says whether it is right.
class FollowedLeg {
 public:
  /// @param estimate  of the sample.
  FollowedLeg(const LocalizerParts& parts, const PoseEstimate& estimate, const Sample& sample);

  /// In time order; the sample of the constructor is the first. What the localizer takes for best agrees or, if the
  /// robot is called localized, contradicts.
  void update(const Sample& sample, const std::optional<PoseEstimate>& estimate);
  bool is_over() const { return is_over_; }
  std::size_t visits() const { return leg_.visits.size(); }

  /// Ends the leg after the last agreement. @return the leg, and where it was followed back to through `skipped`; none
  /// if nothing was learned.
  std::vector<DriveLeg> finish(const SkippedSamples& skipped);
  /// Of the first keyframe, and of the last one that is learned from.
  const Sample& first_sample() const { return first_; }
  const Sample& last_sample() const { return agreed_; }
  /// What came after the last keyframe that is learned from.
  const std::vector<Sample>& left_over() const { return left_over_; }
  double learned_m() const { return learned_m_; }  ///< driven along the visits [m], after `finish`

 private:
  /// The visit that goes on.
  struct Visit {
    int agreed = 0, compared = 0;
    std::size_t keyframes = 0;  ///< at the last agreement
    double agreed_m = 0;        ///< driven until then
    double driven_m = 0;
  };

  void follow(const Sample& sample);
  void compare(const PoseEstimate& estimate);
  void end_visit();
  DriveLeg followed_back(const Pose2& T_map_base, const SkippedSamples& skipped);

  PoseTracker tracker_;
  Eigen::Vector3d start_sigma_;
  Sample first_, agreed_;
  std::vector<Sample> left_over_;  ///< of keyframes
  DriveLeg leg_;
  Visit visit_;
  std::size_t visited_ = 0;  ///< keyframes of the visits that are over
  Pose2 T_odom_before_;
  double learned_m_ = 0;
  bool is_over_ = false;
};

}  // namespace opal
