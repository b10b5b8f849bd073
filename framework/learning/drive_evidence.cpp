#include "learning/drive_evidence.hpp"

#include "learning/followed_leg.hpp"
#include "learning/gap_leg.hpp"

#include <opal/common/error.hpp>
#include <opal/common/warning.hpp>

#include <fmt/format.h>

#include <iterator>
#include <utility>

namespace opal {
namespace {

// Visits whose poses are solved together: enough that no single wall decides, few enough to be told while driving.
constexpr std::size_t kTogether = 10;

}  // namespace

struct DriveObserver::State {
  LocalizerParts parts;
  Localizer localizer;
  std::unique_ptr<FollowedLeg> leg;
  SkippedSamples skipped;
  std::vector<DriveLeg> legs;  ///< that have not been put together yet
  struct LastLeg {
    Sample sample;
    LegPlace end;
  };
  std::optional<LastLeg> last;
  DriveEvidence evidence;
  double driven_m = 0, learned_m = 0;  ///< since the evidence was last taken
  std::optional<Pose2> T_odom_before;

  explicit State(const LocalizerParts& given) : parts(given), localizer(given) {}

  std::size_t visits() const {
    std::size_t visits = leg ? leg->visits() : 0;
    for (const DriveLeg& each : legs) visits += each.visits.size();
    return visits;
  }

  void end_leg() {
    if (!leg) return;
    std::vector<DriveLeg> ended = leg->finish(skipped);
    learned_m += leg->learned_m();
    if (ended.empty()) {
      skipped.append(leg->left_over());
      leg.reset();
      return;
    }
    const std::size_t number = legs.size();
    if (ended.size() > 1) ended.back().begins_at = LegPlace{number, 0};
    std::optional<DriveLeg> gap = gap_before(ended.front(), number);
    if (gap && ended.size() > 1) ended.pop_back();  // the gap covers it
    std::move(ended.begin(), ended.end(), std::back_inserter(legs));
    if (gap) legs.push_back(std::move(*gap));
    last = LastLeg{leg->last_sample(), LegPlace{number, legs[number].track.size() - 1}};
    skipped.clear();
    skipped.append(leg->left_over());
    leg.reset();
  }

  /// From the end of the leg before to the beginning of the leg that will have this number: what scan matching says of
  /// it, if it leads from one to the other.
  std::optional<DriveLeg> gap_before(const DriveLeg& next, std::size_t number) const {
    if (!last) return std::nullopt;
    std::vector<Sample> samples{last->sample};
    for (const SkippedSample& each : skipped.all())
      if (parts.keyframes.are_apart(samples.back().T_odom_base, each.sample.T_odom_base))
        samples.push_back(each.sample);
    samples.push_back(leg->first_sample());
    const Pose2& start = legs[last->end.leg].track[last->end.keyframe].T_map_base;
    std::optional<DriveLeg> gap = gap_leg(parts, samples, start, next.track.front().T_map_base);
    if (!gap) return std::nullopt;
    gap->begins_at = last->end;
    gap->ends_at = LegPlace{number, 0};
    return gap;
  }

  void put_together() {
    end_leg();
    last.reset();
    const double way_m = std::exchange(learned_m, 0);
    try {
      std::vector<VisitEvidence> said = evidence_of(*parts.map, std::exchange(legs, {}));
      std::move(said.begin(), said.end(), std::back_inserter(evidence.visits));
      evidence.learned_m += way_m;
    } catch (const Error& error) {
      warn(fmt::format("{}: {:.0f} m of the drive are left out", error.what(), way_m));
    }
  }

  DriveEvidence said_by(const std::string& drive) {
    DriveEvidence said = std::exchange(evidence, {});
    said.drive = drive;
    said.map = parts.map->map().name();
    said.left_out_m = std::max(0.0, std::exchange(driven_m, 0) - said.learned_m);
    return said;
  }
};

DriveObserver::DriveObserver(const LocalizerParts& parts) : state_(std::make_unique<State>(parts)) {}
DriveObserver::~DriveObserver() = default;

void DriveObserver::update(const Sample& sample) {
  State& s = *state_;
  s.driven_m += s.T_odom_before ? distance_m(*s.T_odom_before, sample.T_odom_base) : 0;
  s.T_odom_before = sample.T_odom_base;
  const auto estimate = s.localizer.update(sample);
  const bool is_localized = estimate && estimate->status == Status::localized;
  if (!s.leg && is_localized) s.leg = std::make_unique<FollowedLeg>(s.parts, *estimate, sample);
  if (!s.leg) {
    s.skipped.add(sample, estimate);
    return;
  }
  s.leg->update(sample, estimate);
  if (s.leg->is_over()) s.end_leg();
  if (s.visits() >= kTogether) s.put_together();
}

std::optional<DriveEvidence> DriveObserver::take(const std::string& drive) {
  if (state_->evidence.visits.empty()) return std::nullopt;
  return state_->said_by(drive);
}

DriveEvidence DriveObserver::finish(const std::string& drive) {
  state_->put_together();
  return state_->said_by(drive);
}

DriveEvidence observed_drive(const LocalizerParts& parts, Replay& replay, const std::string& drive,
                             const std::function<void(double)>& progress) {
  DriveObserver observer(parts);
  while (const auto sample = replay.next()) {
    observer.update(*sample);
    if (progress) progress(replay.progress());
  }
  return observer.finish(drive);
}

}  // namespace opal
