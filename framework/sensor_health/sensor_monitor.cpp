#include "sensor_health/sensor_monitor.hpp"

#include "sensing/standstill.hpp"
#include "sensor_health/sensor_judgement.hpp"

#include <algorithm>

namespace opal {
namespace {

constexpr std::size_t kMotions = 40;  // 10 m of driving, or 130 once all is known
constexpr std::size_t kStandingMotions = 10;
constexpr std::size_t kKnownAfter = 8;    // motions, if they tell of the mount too, or
constexpr std::size_t kEnoughAfter = 24;  // if they do not: if they say that all is fine,
constexpr int kSkipped = 15;              // one of sixteen that follow will do
constexpr double kStillFor_s = 1;         // as long as changed beams are looked at
constexpr double kOtherView_m = 0.1, kOtherView_rad = 0.1;

void keep(std::vector<MotionPair>& newest, const MotionPair& pair, std::size_t most) {
  newest.push_back(pair);
  if (newest.size() > most) newest.erase(newest.begin());
}

/// Turns tell of both.
bool is_same_subject(SensorFinding::Subject a, SensorFinding::Subject b) {
  const auto of_turns = [](SensorFinding::Subject s) {
    return s == SensorFinding::Subject::mirroring ? SensorFinding::Subject::odometry_turn : s;
  };
  return of_turns(a) == of_turns(b);
}

/// A contradiction stands until motions tell of its subject again: a corridor that tells nothing does not refute it.
/// Whether odometry stands is seen in every motion.
void keep_contradictions(const std::vector<SensorFinding>& before, std::vector<SensorFinding>& now) {
  for (const SensorFinding& old : before) {
    if (old.verdict != SensorFinding::Verdict::contradicted || old.subject == SensorFinding::Subject::standing_odometry)
      continue;
    const bool is_told = std::any_of(now.begin(), now.end(),
                                     [&](const SensorFinding& f) { return is_same_subject(f.subject, old.subject); });
    if (!is_told) now.push_back(old);
  }
}

bool same_verdicts(const std::vector<SensorFinding>& a, const std::vector<SensorFinding>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const SensorFinding& x, const SensorFinding& y) {
    return x.subject == y.subject && x.verdict == y.verdict;
  });
}

}  // namespace

SensorMonitor::SensorMonitor(const LaserModel& described, std::shared_ptr<const ScanMatcher> matcher)
    : described_(described) {
  if (matcher) motions_.emplace(std::move(matcher), described.T_base_laser);
}

void SensorMonitor::clear() {
  if (motions_) motions_->clear();
  newest_.clear();
  standing_.clear();
  ranges_.clear();
  frozen_.clear();
  was_frozen_ = false;
  still_stamp_s_.reset();
  T_odom_ranges_.reset();
  of_motions_.clear();
  findings_.clear();
}

bool SensorMonitor::add(const Scan& scan, const Pose2& T_odom_base) {
  const bool looked_at_ranges = look_at_ranges(scan, T_odom_base);
  frozen_.add(scan, T_odom_base);
  const auto pair = motions_ ? motions_->add(scan, T_odom_base) : std::nullopt;
  if (pair) {
    take(*pair, scan.stamp_s);
    judge_motions();
  }
  const bool is_frozen = is_odometry_frozen(scan.stamp_s);
  if (!pair && !looked_at_ranges && is_frozen == was_frozen_) return false;
  was_frozen_ = is_frozen;
  std::vector<SensorFinding> now = judge_ranges(ranges_, described_);  // first: wrong ranges tell nothing of motions
  now.insert(now.end(), of_motions_.begin(), of_motions_.end());
  if (is_frozen) now.push_back(frozen_odometry(frozen_.changed_share()));
  const bool changed = !same_verdicts(findings_, now);
  findings_ = std::move(now);
  return changed;
}

bool SensorMonitor::is_odometry_frozen(double stamp_s) const {
  const bool is_still = still_stamp_s_ && std::abs(stamp_s - *still_stamp_s_) <= kStillFor_s;
  return frozen_.is_frozen() && !is_still;
}

void SensorMonitor::take(const MotionPair& pair, double stamp_s) {
  if (is_standstill(pair.T_odometry)) {
    if (is_still_by_scans(pair)) still_stamp_s_ = stamp_s;
    keep(standing_, pair, kStandingMotions);
    if (!judge_standing(standing_).empty()) motions_->skip(0);  // the next motion refutes it
    return;
  }
  standing_.clear();
  keep(newest_, pair, kMotions);
  const auto is_fine = [](const SensorFinding& f) { return f.verdict == SensorFinding::Verdict::fine; };
  const auto tells_mount = [](const SensorFinding& f) { return f.subject == SensorFinding::Subject::mount_heading; };
  const bool is_told = std::any_of(findings_.begin(), findings_.end(), tells_mount);
  if (newest_.size() >= (is_told ? kKnownAfter : kEnoughAfter) && pair.as_described &&
      std::all_of(findings_.begin(), findings_.end(), is_fine))
    motions_->skip(kSkipped);
}

/// Scans from one place say one thing.
bool SensorMonitor::look_at_ranges(const Scan& scan, const Pose2& T_odom_base) {
  if (T_odom_ranges_ && distance_m(*T_odom_ranges_, T_odom_base) < kOtherView_m &&
      angle_between_rad(*T_odom_ranges_, T_odom_base) < kOtherView_rad)
    return false;
  T_odom_ranges_ = T_odom_base;
  ranges_.add(scan);
  return true;
}

/// The fit costs more than everything else here: it is made when there is a new motion.
void SensorMonitor::judge_motions() {
  std::vector<SensorFinding> now = judge_standing(standing_);
  if (const auto drive = calibrate_motion(newest_, described_.T_base_laser)) {
    const std::vector<SensorFinding> found = judge_motion(*drive, described_.T_base_laser);
    now.insert(now.end(), found.begin(), found.end());
  }
  keep_contradictions(of_motions_, now);
  of_motions_ = std::move(now);
}

}  // namespace opal
