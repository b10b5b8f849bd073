// How long an answer says that it waited.
#include "live/live_core.hpp"
#include "live_robot.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace opal;

namespace {

/// Plays arrivals, and holds how long each answer says that it waited against when its scan came.
class Waits {
 public:
  explicit Waits(LiveCore& core) : core_(core) {}

  void play(const std::vector<simulation::Arrival>& arrivals, double later_s) {
    came_s_.clear();
    for (const simulation::Arrival& arrival : arrivals) {
      now_s_ = arrival.at_s + later_s;
      if (const auto* scan = std::get_if<RawScan>(&arrival.record)) came_s_[scan->stamp_s] = last_came_s_ = now_s_;
      core_.take(arrival.record, now_s_, now_s_, [this](const LiveAnswer& answer) { hear(answer); });
    }
  }
  void finish() {
    now_s_ = last_came_s_;
    core_.finish([this](const LiveAnswer& answer) { hear(answer); });
  }

  int answers = 0, wrong = 0, waited = 0;

 private:
  void hear(const LiveAnswer& answer) {
    const double expected_s = now_s_ - came_s_.at(answer.stamp_s);
    ++answers;
    waited += answer.waited_s > 0;
    wrong += answer.waited_s != Approx(expected_s).margin(1e-9) || answer.latency_s != answer.waited_s;
  }

  LiveCore& core_;
  std::map<double, double> came_s_;  ///< by stamp
  double now_s_ = 0, last_came_s_ = 0;
};

}  // namespace

TEST_CASE("an answer says how long its scan waited, also where a clock that was reset gives the same stamps again") {
  const LiveRobot robot(3);
  LiveCore core(robot.parts(), {}, nullptr);
  Waits waits(core);
  waits.play(robot.arrivals, 0);
  waits.finish();
  CHECK(waits.answers > 20);
  CHECK(waits.waited > 10);
  waits.play(robot.arrivals, 100);
  waits.finish();
  CHECK(waits.answers > 40);
  CHECK(waits.wrong == 0);
}
