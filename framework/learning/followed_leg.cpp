#include "learning/followed_leg.hpp"

#include "localization/observation/observation.hpp"

#include <opal/sensing/lines/line_extraction.hpp>
#include <opal/sensing/scan_chains.hpp>

#include <algorithm>
#include <utility>

namespace opal {
namespace {

// The tracker and the localizer are two programs with one scan: where they differ by more, one of them is wrong.
constexpr double kAgree_m = 0.4, kAgree_rad = 0.15;
constexpr double kLeastAgreement = 0.9;
constexpr int kFewestComparisons = 5;
// A place that is passed again after so much driving is visited again.
constexpr double kVisit_m = 60;
// So far without agreement, nobody knows whether the tracker is still right.
constexpr double kWait_m = 30;
constexpr double kBack_m = 60;
constexpr std::size_t kBeamStride = 4;

}  // namespace

KeyframeView view_of(const Sample& sample) {
  constexpr double kSpacing_m = 0.03;
  constexpr std::size_t kMostPoints = 400;
  KeyframeView view;
  for (const LaserView& laser : sample.views) {
    const ScanChains chains = chained(laser.scan, ChainOptions{});
    for (const Line& line : extract_lines(chains, LineExtractionOptions{}))
      view.faces.push_back({transformed(laser.T_base_laser, line.segment), line.covariance});
    for (std::size_t k = 0; k < laser.scan.points.size(); k += kBeamStride)
      view.beams.emplace_back(laser.T_base_laser.position(), laser.T_base_laser * laser.scan.points[k].position);
    view.returns.push_back({laser.T_base_laser.position(),
                            thinned(laser.scan.points, laser.T_base_laser, kSpacing_m, kMostPoints).points});
  }
  return view;
}

namespace {

bool agrees(const Pose2& tracked, const Pose2& localized) {
  return distance_m(tracked, localized) < kAgree_m && angle_between_rad(tracked, localized) < kAgree_rad;
}

Eigen::Vector3d sigma_of(const PoseEstimate& estimate) {
  constexpr double kLeast_m = 0.05, kLeast_rad = 0.02;
  return estimate.covariance.diagonal().cwiseMax(0).cwiseSqrt().cwiseMax(
      Eigen::Vector3d(kLeast_m, kLeast_m, kLeast_rad));
}

}  // namespace

void SkippedSamples::add(const Sample& sample, const std::optional<PoseEstimate>& estimate) {
  constexpr double kApart_m = 0.05, kApart_rad = 0.05;
  const auto pose = estimate && estimate->has_pose ? std::optional(estimate->T_map_base) : std::nullopt;
  const auto is_near = [&](const Sample& before) {
    return distance_m(before.T_odom_base, sample.T_odom_base) < kApart_m &&
           angle_between_rad(before.T_odom_base, sample.T_odom_base) < kApart_rad;
  };
  if (!pose && !samples_.empty() && is_near(samples_.back().sample)) return;
  keep({sample, pose});
}

void SkippedSamples::append(std::span<const Sample> samples) {
  for (const Sample& sample : samples) keep({sample, std::nullopt});
}

void SkippedSamples::keep(SkippedSample sample) {
  constexpr std::size_t kMost = 2000;
  samples_.push_back(std::move(sample));
  if (samples_.size() > kMost) samples_.pop_front();
}

FollowedLeg::FollowedLeg(const LocalizerParts& parts, const PoseEstimate& estimate, const Sample& sample)
    : tracker_(parts), start_sigma_(sigma_of(estimate)), first_(sample), T_odom_before_(sample.T_odom_base) {
  tracker_.start(estimate.T_map_base, start_sigma_);
}

void FollowedLeg::update(const Sample& sample, const std::optional<PoseEstimate>& estimate) {
  follow(sample);
  if (estimate && estimate->has_pose) compare(*estimate);
  if (tracker_.last().lost || visit_.driven_m > kVisit_m + kWait_m) is_over_ = true;
}

void FollowedLeg::follow(const Sample& sample) {
  visit_.driven_m += distance_m(T_odom_before_, sample.T_odom_base);
  T_odom_before_ = sample.T_odom_base;
  if (!tracker_.update(sample)) return;
  leg_.views.push_back(view_of(sample));
  left_over_.push_back(sample);
}

void FollowedLeg::compare(const PoseEstimate& estimate) {
  const bool agree = agrees(tracker_.last().T_map_base, estimate.T_map_base);
  if (estimate.status == Status::localized) {
    ++visit_.compared;
    visit_.agreed += agree;
  }
  if (!agree || tracker_.last().lost) return;
  visit_.keyframes = tracker_.track().size();
  visit_.agreed_m = visit_.driven_m;
  if (visit_.driven_m > kVisit_m) end_visit();
}

/// What comes after the last agreement is not learned from.
void FollowedLeg::end_visit() {
  const bool is_sound = visit_.compared >= kFewestComparisons && visit_.agreed >= kLeastAgreement * visit_.compared &&
                        visit_.keyframes > visited_ + 1;
  if (is_sound) {
    leg_.visits.push_back(visit_.keyframes - visited_);
    visited_ = visit_.keyframes;
    learned_m_ += visit_.agreed_m;
    const std::size_t after = tracker_.track().size() - visited_;  // keyframes
    agreed_ = left_over_[left_over_.size() - after - 1];
    left_over_.erase(left_over_.begin(), left_over_.end() - static_cast<std::ptrdiff_t>(after));
  } else {
    is_over_ = true;
  }
  visit_ = {};
}

std::vector<DriveLeg> FollowedLeg::finish(const SkippedSamples& skipped) {
  end_visit();
  if (leg_.visits.empty()) return {};
  const auto& track = tracker_.track();
  leg_.track.assign(track.begin(), track.begin() + static_cast<std::ptrdiff_t>(visited_));
  leg_.views.resize(visited_);
  std::vector<DriveLeg> legs{std::move(leg_)};
  if (DriveLeg back = followed_back(legs.front().track.front().T_map_base, skipped); !back.visits.empty())
    legs.push_back(std::move(back));
  return legs;
}

/// The same tracker, back from where the leg begins: what it has learned of the map helps it there. It is believed as
/// far back as what the localizer took for best then, localized or not, agreed with it.
DriveLeg FollowedLeg::followed_back(const Pose2& T_map_base, const SkippedSamples& skipped) {
  DriveLeg back;
  tracker_.start(T_map_base, start_sigma_);
  double driven_m = 0, agreed_m = 0;
  std::size_t agreed = 0;  // keyframes
  T_odom_before_ = first_.T_odom_base;
  const auto take = [&](const Sample& sample) {
    driven_m += distance_m(T_odom_before_, sample.T_odom_base);
    T_odom_before_ = sample.T_odom_base;
    if (tracker_.update(sample)) back.views.push_back(view_of(sample));
  };
  take(first_);
  for (auto each = skipped.all().rbegin(); each != skipped.all().rend() && driven_m < kBack_m; ++each) {
    take(each->sample);
    if (tracker_.last().lost || driven_m - agreed_m > kWait_m) break;
    if (!each->T_map_base || !agrees(tracker_.last().T_map_base, *each->T_map_base)) continue;
    agreed = back.views.size();
    agreed_m = driven_m;
  }
  if (agreed < 2) return {};
  learned_m_ += agreed_m;
  back.track.assign(tracker_.track().begin(), tracker_.track().begin() + static_cast<std::ptrdiff_t>(agreed));
  back.views.resize(agreed);
  back.visits = {agreed};
  return back;
}

}  // namespace opal
