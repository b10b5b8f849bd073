// What a live localizer costs: latency and CPU in real time, and memory over a day of driving.
#include "common/cpu_clock.hpp"
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

/// 40 scans a second together, of 1440 beams each.
LiveRobot dense_robot(double duration_s) {
  std::vector<LaserModel> lasers = front_and_rear();
  for (LaserModel& laser : lasers) {
    laser.angle_increment_rad *= 380.0 / 1439;
    laser.beams = 1440;
  }
  return LiveRobot(lasers, 0.05, duration_s);
}

}  // namespace

TEST_CASE("latency of two lasers with 40 scans a second of 1440 beams, in real time", "[!benchmark][live]") {
  const LiveRobot robot = dense_robot(30);
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
  std::printf(
      "\n%zu answers in 30 s: latency median %.1f, p99 %.1f ms, without the wait for odometry %.1f and %.1f ms; "
      "CPU %.0f %% of a core\n",
      latencies_ms.size(), quantile_of(latencies_ms, 0.5), quantile_of(latencies_ms, 0.99), quantile_of(worked_ms, 0.5),
      quantile_of(worked_ms, 0.99), 100 * cpu_s / 30);
}

TEST_CASE("a day of driving: memory and CPU time by the hour", "[!benchmark][live][day]") {
  constexpr double kLap_s = 600;
  constexpr int kLapsAnHour = 6, kHours = 24;
  const LiveRobot robot(kLap_s);
  LiveCore core(robot.parts(), {}, nullptr);
  std::printf("\nhour  resident [MB]  CPU per scan [ms]  localized\n");
  for (int hour = 0; hour < kHours; ++hour) {
    const double before_s = thread_cpu_s();
    std::size_t answers = 0, localized = 0;
    for (int lap = hour * kLapsAnHour; lap < (hour + 1) * kLapsAnHour; ++lap)
      for (const simulation::Arrival& arrival : robot.later(lap * (kLap_s + 1)))
        core.take(arrival.record, arrival.at_s, arrival.at_s, [&](const LiveAnswer& answer) {
          ++answers;
          localized += answer.estimate.status == Status::localized ? 1 : 0;
        });
    std::printf("%4d  %13.1f  %17.3f  %8.1f %%\n", hour + 1, resident_mb(),
                1e3 * (thread_cpu_s() - before_s) / static_cast<double>(answers),
                100 * static_cast<double>(localized) / static_cast<double>(answers));
    std::fflush(stdout);
  }
}
