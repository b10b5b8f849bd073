#include "benchmark/runs/run_record.hpp"

#include "common/stage_clock.hpp"

namespace opal::benchmark {
namespace {

void add(opal::StageTimes& sum, const opal::StageTimes& one) {
  sum.sensor_s += one.sensor_s;
  sum.detect_s += one.detect_s;
  sum.local_map_s += one.local_map_s;
  sum.track_s += one.track_s;
  sum.generate_s += one.generate_s;
  sum.search_s += one.search_s;
  sum.retrospect_s += one.retrospect_s;
  sum.grow_s += one.grow_s;
  sum.status_s += one.status_s;
}

void add_rows(RunRecord& record, const std::string& query, const opal::LaserModel& laser) {
  const opal::PoseEstimate& said = record.last;
  record.rows.push_back({query, said.stamp_s, said.T_map_base * laser.T_base_laser, said.status, said.probability,
                         said.none, said.place.storey});
  for (const auto& alternative : said.alternatives)
    record.alternatives.push_back(
        {query, said.stamp_s, alternative.T_map_base * laser.T_base_laser, alternative.probability});
  record.trajectory.push_back({said.stamp_s, said.T_map_base});
}

/// Of all lasers, in the frame of the one whose poses are told.
void add_points(std::vector<opal::Point>& points, const opal::Sample& sample, const opal::Pose2& T_base_told) {
  for (const opal::LaserView& view : sample.views) {
    const bool is_told = view.laser == 0;
    const opal::Pose2 T_told_laser = is_told ? opal::Pose2() : T_base_told.inverse() * view.T_base_laser;
    for (const opal::ScanPoint& point : view.scan.points)
      points.push_back(is_told ? point.position : T_told_laser * point.position);
  }
}

/// Carries the progress of a replay on to its newest scan.
class Odometer {
 public:
  ReplayProgress at(double stamp_s, const opal::Pose2& T_odom_base) {
    if (!before_) start_s_ = stamp_s;
    driven_m_ += before_ ? distance_m(*before_, T_odom_base) : 0;
    before_ = T_odom_base;
    return {stamp_s - start_s_, driven_m_};
  }

 private:
  std::optional<opal::Pose2> before_;
  double start_s_ = 0, driven_m_ = 0;
};

template <class T>
void extend(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

void RunRecord::append(const RunRecord& other) {
  extend(rows, other.rows);
  extend(alternatives, other.alternatives);
  extend(trajectory, other.trajectory);
  extend(update_cpu_ms, other.update_cpu_ms);
  add(stages, other.stages);
  hypotheses += other.hypotheses;
  whole = other.whole;
  localized_after = other.localized_after;
  last = other.last;
  last_points = other.last_points;
  last_T_odom_base = other.last_T_odom_base;
}

RunRecord run_samples(opal::Localizer& localizer, const opal::LaserModel& laser, const SampleSource& next,
                      const std::string& query, const RunObserver& observer) {
  RunRecord record;
  Odometer odometer;
  double before_s = opal::thread_cpu_s();  // the replay cleans the scan: that is part of an update's cost
  while (const auto sample = next()) {
    if (observer.ready && !observer.ready(sample->stamp_s)) break;
    const auto updated = localizer.update(*sample);
    if (updated) {
      record.update_cpu_ms.push_back(1e3 * (opal::thread_cpu_s() - before_s));
      add(record.stages, localizer.last_times());
      record.hypotheses += updated->hypotheses;
      record.last_points.clear();
      add_points(record.last_points, *sample, laser.T_base_laser);
      record.last_T_odom_base = sample->T_odom_base;
    }
    record.last = localizer.estimate_at(sample->stamp_s, sample->T_odom_base);
    record.whole = odometer.at(sample->stamp_s, sample->T_odom_base);
    if (!record.localized_after && record.last.status == opal::Status::localized) record.localized_after = record.whole;
    if (record.last.has_pose) add_rows(record, query, laser);
    if (updated && observer.updated) observer.updated(record);
    before_s = opal::thread_cpu_s();
  }
  return record;
}

RunRecord run_log(opal::Localizer& localizer, const opal::LaserModel& laser, opal::Replay& replay,
                  const std::string& query, const RunObserver& observer) {
  const SampleSource next = [&] {
    if (observer.progress) observer.progress(replay.progress());
    return replay.next();
  };
  return run_samples(localizer, laser, next, query, observer);
}

}  // namespace opal::benchmark
