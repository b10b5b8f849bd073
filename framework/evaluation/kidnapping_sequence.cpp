#include "evaluation/kidnapping_sequence.hpp"

#include <opal/common/error.hpp>
#include <opal/common/quantile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <utility>

namespace opal {
namespace {

/// The recorded poses of a window, and how far the robot has driven at each.
struct Drive {
  std::vector<StampedPose> poses;
  std::vector<double> driven_m;

  double length_m() const { return driven_m.empty() ? 0 : driven_m.back(); }
  /// The first pose at which so much has been driven, or the last one.
  std::size_t at(double distance) const {
    const auto found = std::lower_bound(driven_m.begin(), driven_m.end(), distance);
    return std::min<std::size_t>(found - driven_m.begin(), driven_m.size() - 1);
  }
};

Drive drive_of(const GroundTruth& truth, const Query& window) {
  Drive drive;
  for (const StampedPose& pose : truth.poses()) {
    if (pose.stamp_s < window.start_s || pose.stamp_s > window.end_s) continue;
    const double step_m = drive.poses.empty() ? 0 : distance_m(drive.poses.back().pose, pose.pose);
    drive.driven_m.push_back(drive.length_m() + step_m);
    drive.poses.push_back(pose);
  }
  return drive;
}

class KidnappingDraw {
 public:
  KidnappingDraw(std::span<const Query> queries, const GroundTruth& truth, const KidnappingSequenceOptions& options)
      : queries_(queries), options_(options), random_(options.seed) {
    for (const Query& query : queries) drives_.push_back(drive_of(truth, query));
  }

  /// @return nothing if the places turn out to be too near.
  std::optional<KidnappingSequence> draw() {
    const std::size_t a = pick(), b = pick();
    const Drive &before = drives_[a], &after = drives_[b];
    if (before.poses.empty() || after.poses.empty()) return std::nullopt;
    const std::size_t cut = before.at(between(std::min(options_.before_m, before.length_m()), before.length_m()));
    const std::size_t on = after.at(between(0, std::max(0.0, after.length_m() - options_.after_m)));
    const double apart_m = distance_m(before.poses[cut].pose, after.poses[on].pose);
    if (apart_m <= options_.least_apart_m) return std::nullopt;
    return KidnappingSequence{"",
                              {queries_[a].id, queries_[a].start_s, before.poses[cut].stamp_s},
                              {queries_[b].id, after.poses[on].stamp_s, queries_[b].end_s},
                              apart_m};
  }

 private:
  std::size_t pick() { return std::uniform_int_distribution<std::size_t>(0, queries_.size() - 1)(random_); }
  double between(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

  std::span<const Query> queries_;
  KidnappingSequenceOptions options_;
  std::mt19937_64 random_;
  std::vector<Drive> drives_;
};

std::string numbered(const std::string& name, std::size_t number) {
  const std::string digits = std::to_string(number);
  return name + "-sequence" + (digits.size() < 2 ? "0" : "") + digits;
}

/// What time usually passes between two samples.
double usual_step_s(std::span<const Sample> samples) {
  if (samples.size() < 2) return 0.1;
  std::vector<double> steps;
  for (std::size_t k = 1; k < samples.size(); ++k) steps.push_back(samples[k].stamp_s - samples[k - 1].stamp_s);
  return upper_median_of(std::move(steps));
}

}  // namespace

std::vector<KidnappingSequence> draw_kidnapping_sequences(const std::string& name, std::span<const Query> queries,
                                                          const GroundTruth& truth,
                                                          const KidnappingSequenceOptions& options) {
  constexpr int kTriesPerSequence = 200;
  const std::size_t count = options.count > 0 ? options.count : queries.size();
  std::vector<KidnappingSequence> sequences;
  if (queries.empty()) return sequences;
  KidnappingDraw draw(queries, truth, options);
  for (std::size_t tries = 0; sequences.size() < count; ++tries) {
    if (tries == count * kTriesPerSequence)
      throw ConfigError(
          fmt::format("{}: {} sequences found in {} tries, expected {} with places more than {:f} m apart", name,
                      sequences.size(), tries, count, options.least_apart_m));
    std::optional<KidnappingSequence> sequence = draw.draw();
    if (!sequence) continue;
    sequence->id = numbered(name, sequences.size() + 1);
    sequences.push_back(std::move(*sequence));
  }
  return sequences;
}

KidnappingLog with_kidnapping(std::span<const Sample> before, std::span<const Sample> after) {
  KidnappingLog log;
  log.cut = before.size();
  for (const Sample& sample : before) {
    log.samples.push_back(sample);
    log.recorded_s.push_back(sample.stamp_s);
  }
  const bool both = !before.empty() && !after.empty();
  const double later_s = both ? before.back().stamp_s + usual_step_s(after) - after.front().stamp_s : 0;
  const Pose2 T_before_after = both ? before.back().T_odom_base * after.front().T_odom_base.inverse() : Pose2();
  for (const Sample& sample : after) {
    Sample moved = sample;
    moved.stamp_s += later_s;
    moved.T_odom_base = T_before_after * sample.T_odom_base;
    for (LaserView& view : moved.views) view.scan.stamp_s += later_s;
    log.samples.push_back(std::move(moved));
    log.recorded_s.push_back(sample.stamp_s);
  }
  return log;
}

}  // namespace opal
