#include "learning/drive_evidence.hpp"

#include "survey/pose_tracker.hpp"
#include "survey/track_smoothing.hpp"

#include <opal/sensing/lines/line_extraction.hpp>
#include <opal/sensing/scan_chains.hpp>

#include <utility>

namespace opal {
namespace {

// The tracker and the localizer are two programs with one scan: where they differ by more, one of them is wrong.
constexpr double kAgree_m = 0.4, kAgree_rad = 0.15;
constexpr double kLeastAgreement = 0.9;
constexpr int kFewestComparisons = 5;
// A place that is passed again after so much driving is visited again.
constexpr double kVisit_m = 60;
constexpr std::size_t kBeamStride = 4;

/// What was known when localizer and tracker agreed last.
struct LastAgreement {
  MapBelief belief;
  std::size_t keyframes = 0;
  double driven_m = 0;
};

/// One stretch of a drive, followed from where the localizer called the robot localized.
struct Stretch {
  PoseTracker tracker;
  Eigen::Vector3d start_sigma;
  std::vector<KeyframeView> views;
  LastAgreement agreement;
  int agreed = 0, compared = 0;
  double driven_m = 0;
  Pose2 T_odom_before;

  Stretch(const LocalizerParts& parts, const Eigen::Vector3d& sigma, const Pose2& T_odom_base)
      : tracker(parts), start_sigma(sigma), T_odom_before(T_odom_base) {}

  bool is_sound() const {
    return compared >= kFewestComparisons && agreed >= kLeastAgreement * compared && agreement.keyframes > 1;
  }
  /// What comes after the last agreement is not learned from.
  void note_agreement() {
    constexpr double kApart_m = 2;  // a copy of all that is believed of a large map costs time
    if (agreement.keyframes > 0 && driven_m - agreement.driven_m < kApart_m) return;
    agreement = {tracker.belief(), tracker.track().size(), driven_m};
  }
};

KeyframeView view_of(const Sample& sample) {
  KeyframeView view;
  for (const LaserView& laser : sample.views) {
    const ScanChains chains = chained(laser.scan, ChainOptions{});
    for (const Line& line : extract_lines(chains, LineExtractionOptions{}))
      view.faces.push_back(transformed(laser.T_base_laser, line.segment));
    for (std::size_t k = 0; k < laser.scan.points.size(); k += kBeamStride)
      view.beams.emplace_back(laser.T_base_laser.position(), laser.T_base_laser * laser.scan.points[k].position);
  }
  return view;
}

VisitEvidence evidence_of(const Stretch& stretch, const SemanticMap& map) {
  const std::span<const TrackedKeyframe> track = std::span(stretch.tracker.track()).first(stretch.agreement.keyframes);
  const SmoothedTrack smoothed =
      *smooth_track(stretch.tracker.map(), track, stretch.start_sigma, stretch.agreement.belief);
  return {deviations_of(map, smoothed.belief),
          unmapped_faces(stretch.tracker.map(), smoothed.belief, std::span(stretch.views).first(track.size()),
                         smoothed.T_map_base)};
}

}  // namespace

struct DriveObserver::State {
  LocalizerParts parts;
  Localizer localizer;
  std::unique_ptr<Stretch> stretch;
  DriveEvidence evidence;

  explicit State(const LocalizerParts& given) : parts(given), localizer(given) {}

  void begin(const PoseEstimate& estimate, const Sample& sample) {
    constexpr double kLeast_m = 0.05, kLeast_rad = 0.02;
    const Eigen::Vector3d sigma = estimate.covariance.diagonal().cwiseMax(0).cwiseSqrt().cwiseMax(
        Eigen::Vector3d(kLeast_m, kLeast_m, kLeast_rad));
    stretch = std::make_unique<Stretch>(parts, sigma, sample.T_odom_base);
    stretch->tracker.start(estimate.T_map_base, sigma);
  }

  void follow(const Sample& sample) {
    stretch->driven_m += distance_m(stretch->T_odom_before, sample.T_odom_base);
    stretch->T_odom_before = sample.T_odom_base;
    if (stretch->tracker.update(sample)) stretch->views.push_back(view_of(sample));
  }

  void compare(const PoseEstimate& estimate) {
    const Pose2& tracked = stretch->tracker.last().T_map_base;
    const bool agree = distance_m(tracked, estimate.T_map_base) < kAgree_m &&
                       angle_between_rad(tracked, estimate.T_map_base) < kAgree_rad;
    ++stretch->compared;
    stretch->agreed += agree;
    if (agree && !stretch->tracker.last().lost) stretch->note_agreement();
  }

  void end() {
    if (!stretch) return;
    const bool is_sound = stretch->is_sound() && stretch->views.size() == stretch->tracker.track().size();
    evidence.learned_m += is_sound ? stretch->agreement.driven_m : 0;
    evidence.left_out_m += stretch->driven_m - (is_sound ? stretch->agreement.driven_m : 0);
    if (is_sound) evidence.visits.push_back(evidence_of(*stretch, parts.map->map()));
    stretch.reset();
  }

  DriveEvidence said_by(const std::string& drive) {
    DriveEvidence said = std::exchange(evidence, {});
    said.drive = drive;
    said.map = parts.map->map().name();
    return said;
  }
};

DriveObserver::DriveObserver(const LocalizerParts& parts) : state_(std::make_unique<State>(parts)) {}
DriveObserver::~DriveObserver() = default;

void DriveObserver::update(const Sample& sample) {
  const auto estimate = state_->localizer.update(sample);
  const bool is_localized = estimate && estimate->status == Status::localized;
  if (!state_->stretch && is_localized) state_->begin(*estimate, sample);
  if (!state_->stretch) return;
  state_->follow(sample);
  if (is_localized) state_->compare(*estimate);
  if (state_->stretch->tracker.last().lost || state_->stretch->driven_m > kVisit_m) state_->end();
}

std::optional<DriveEvidence> DriveObserver::take(const std::string& drive) {
  if (state_->evidence.visits.empty()) return std::nullopt;
  return state_->said_by(drive);
}

DriveEvidence DriveObserver::finish(const std::string& drive) {
  state_->end();
  return state_->said_by(drive);
}

DriveEvidence observed_drive(const LocalizerParts& parts, Replay& replay, const std::string& drive) {
  DriveObserver observer(parts);
  while (const auto sample = replay.next()) observer.update(*sample);
  return observer.finish(drive);
}

}  // namespace opal
