// What a live localizer costs: latency and CPU in real time, and memory over a day of driving.
#include "common/stage_clock.hpp"
#include "live/live_core.hpp"
#include "tests/live/live_robot.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <thread>

using namespace opal;

namespace {

double quantile_of(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

double resident_mb() {
  std::ifstream statm("/proc/self/statm");
  long pages = 0, resident = 0;
  statm >> pages >> resident;
  return static_cast<double>(resident) * 4096 / 1e6;
}

/// Programs that want to run: beside others everything takes longer.
double load_of_machine() {
  std::ifstream loadavg("/proc/loadavg");
  double load = 0;
  loadavg >> load;
  return load;
}

/// What is added to memory in a day, by least squares over hours.
double slope_mb_a_day(const std::vector<double>& resident_mb_by_hour) {
  const double count = static_cast<double>(resident_mb_by_hour.size());
  double mean_mb = 0, product = 0, squares = 0;
  for (const double mb : resident_mb_by_hour) mean_mb += mb / count;
  for (std::size_t hour = 0; hour < resident_mb_by_hour.size(); ++hour) {
    const double from_middle = static_cast<double>(hour) - (count - 1) / 2;
    product += from_middle * (resident_mb_by_hour[hour] - mean_mb);
    squares += from_middle * from_middle;
  }
  return 24 * product / squares;
}

/// 40 scans a second together, of 1440 beams each.
LiveRobot dense_robot(double duration_s) {
  std::vector<LaserModel> lasers = front_and_rear();
  for (LaserModel& laser : lasers) {
    laser.angle_increment_rad *= 380.0 / 1439;
    laser.beams = 1440;
  }
  return LiveRobot(lasers, 0.05, duration_s);
}

/// Answers, and the CPU time that each has taken: whatever else runs here.
struct Answers {
  std::vector<double> answer_ms;
  std::size_t localized = 0;

  void take_all(LiveCore& core, const std::vector<simulation::Arrival>& arrivals) {
    double before_s = thread_cpu_s();
    for (const simulation::Arrival& arrival : arrivals)
      core.take(arrival.record, arrival.at_s, arrival.at_s, [&](const LiveAnswer& answer) {
        const double after_s = thread_cpu_s();
        answer_ms.push_back(1e3 * (after_s - before_s));
        before_s = after_s;
        localized += answer.estimate.status == Status::localized ? 1 : 0;
      });
  }

  double localized_share() const { return static_cast<double>(localized) / static_cast<double>(answer_ms.size()); }
};

std::vector<double> cpu_of_answers_ms(const LiveRobot& robot) {
  LiveCore core(robot.parts(), {}, nullptr);
  Answers answers;
  answers.take_all(core, robot.arrivals);
  return answers.answer_ms;
}

}  // namespace

TEST_CASE("latency of two lasers with 40 scans a second of 1440 beams, in real time", "[!benchmark][live][latency]") {
  constexpr double kDrive_s = 60;
  const LiveRobot robot = dense_robot(kDrive_s);
  std::vector<double> latencies_ms, worked_ms;
  const double cpu_before_s = process_cpu_s();
  const auto begin = std::chrono::steady_clock::now();
  {
    LiveLocalizer live(robot.parts());
    std::jthread reader([&](const std::stop_token& stop) {
      std::uint64_t seen = 0;
      while (!stop.stop_requested())
        if (const auto answer = live.newer_than(seen, 0.1)) {
          seen = answer->number;
          latencies_ms.push_back(1e3 * answer->latency_s);
          worked_ms.push_back(1e3 * (answer->latency_s - answer->waited_s));
        }
    });
    for (const simulation::Arrival& arrival : robot.arrivals) {
      std::this_thread::sleep_until(begin + std::chrono::duration<double>(arrival.at_s));
      live.take(arrival.record, arrival.at_s);
    }
    live.drain(10);
    reader.request_stop();
  }
  REQUIRE_FALSE(latencies_ms.empty());
  const double cpu_s = process_cpu_s() - cpu_before_s;
  const auto row = [](const char* name, const std::vector<double>& ms) {
    std::printf("| %s | %.2f | %.2f | %.2f |\n", name, quantile_of(ms, 0.5), quantile_of(ms, 0.99), quantile_of(ms, 1));
  };
  std::printf("\n| from a scan's arrival to its pose | median ms | p99 ms | most ms |\n| --- | --- | --- | --- |\n");
  row("all", latencies_ms);
  row("without the wait for odometry and the other laser", worked_ms);
  row("CPU time of the same", cpu_of_answers_ms(robot));
  std::printf("\n%zu answers in %.0f s, CPU %.1f %% of one core, %.0f programs wanted to run\n", latencies_ms.size(),
              kDrive_s, 100 * cpu_s / kDrive_s, load_of_machine());
}

TEST_CASE("a day of driving: memory and CPU time by the hour", "[!benchmark][live][day]") {
  constexpr double kLap_s = 600, kScanEvery_s = 0.25;
  constexpr int kLapsAnHour = 6, kHours = 24;
  const LiveRobot robot(front_and_rear(), kScanEvery_s, kLap_s);
  LiveCore core(robot.parts(), {}, nullptr);
  std::vector<double> resident_by_hour_mb;
  std::printf(
      "\n| hour | resident MB | CPU per answer: median ms | p99 ms | localized |\n| --- | --- | --- | --- | --- |\n");
  for (int hour = 0; hour < kHours; ++hour) {
    Answers now;
    for (int lap = hour * kLapsAnHour; lap < (hour + 1) * kLapsAnHour; ++lap)
      now.take_all(core, robot.later(lap * (kLap_s + 1)));
    resident_by_hour_mb.push_back(resident_mb());
    std::printf("| %d | %.1f | %.2f | %.2f | %.1f %% |\n", hour + 1, resident_by_hour_mb.back(),
                quantile_of(now.answer_ms, 0.5), quantile_of(now.answer_ms, 0.99), 100 * now.localized_share());
    std::fflush(stdout);
  }
  resident_by_hour_mb.erase(resident_by_hour_mb.begin());  // buffers grow to their size
  std::printf("\nfrom the second hour on memory grows by %.2f MB a day\n", slope_mb_a_day(resident_by_hour_mb));
}
