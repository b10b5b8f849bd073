#pragma once

#include "benchmark/runs/run_record.hpp"
#include "benchmark/runs/window_answer.hpp"

#include <opal/localization/events/event_stream.hpp>
#include "drawing/drawing.hpp"
#include "evaluation/ground_truth.hpp"
#include "evaluation/site.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>

namespace opal::benchmark {

/// The truth of a window for the event stream, as poses of the robot.
nlohmann::ordered_json truth_event_of(const opal::GroundTruth& truth, const opal::Query& window,
                                      const opal::LaserModel& laser);

/// How a log is played.
struct Playing {
  double speed = 0;      ///< 1: in real time, 2: twice as fast; 0: as fast as possible
  std::stop_token stop;  ///< ends the run in the middle of the log
};

/// One localizer over all windows of a log, and what it leaves behind.
class LocalizeRun {
 public:
  /// @param events  gets what only the run knows: the windows and their truth; the localizer writes there, too, and
  ///                says why it is not localized yet.
  /// @param log  name for the pictures.
  LocalizeRun(opal::Localizer& localizer, const std::vector<opal::LaserModel>& lasers, opal::EventSink& events,
              const std::string& log)
      : localizer_(localizer), lasers_(lasers), events_(events), log_(log) {}

  /// Truth as poses of the laser; drawn, recorded and compared with.
  void set_truth(opal::GroundTruth truth) { truth_ = std::move(truth); }

  /// Plays the windows one after the other, each from scratch; the first picture is drawn into `out` on the way.
  void play(const std::vector<opal::LogRecord>& records, const std::vector<opal::Query>& windows,
            const Playing& playing, const std::filesystem::path& out);

  /// Trajectory, results, the last picture. Of several windows, one that was cut is left out of the results.
  void write(const std::filesystem::path& out) const;
  void print() const;                                 ///< on stdout: when it was localized, then the answer
  std::size_t finished() const { return finished_; }  ///< windows
  bool complete() const { return unfinished_ == 0; }  ///< no window was cut or left out by a stop
  bool found() const {
    return all_.last.has_pose && all_.last.status == opal::Status::localized && contradictions_.empty();
  }

 private:
  void play_window(opal::Replay& replay, const opal::Query& window, const RunObserver& observer);
  void draw(const std::string& moment, const RunRecord& record, const std::filesystem::path& without_extension) const;

  opal::Localizer& localizer_;
  const std::vector<opal::LaserModel>& lasers_;  ///< poses are told of the first one
  opal::EventSink& events_;
  const std::string log_;
  std::optional<opal::GroundTruth> truth_;
  RunRecord all_, newest_;
  std::vector<WindowAnswer> answers_;
  std::map<std::string, int> oddities_;
  std::vector<std::string> contradictions_;  ///< of the sensor description by the drive
  bool first_scan_drawn_ = false;
  std::size_t finished_ = 0, unfinished_ = 0;  // windows
};

}  // namespace opal::benchmark
