#include "common/task_queue.hpp"

#include <catch2/catch.hpp>

#include <thread>
#include <vector>

using namespace opal;

namespace {

constexpr std::chrono::milliseconds kNow(0), kLong(60'000);

std::size_t parity(const int& task) { return static_cast<std::size_t>(task % 2); }

std::vector<int> left_in(TaskQueue<int>& queue) {
  std::vector<int> tasks;
  while (const auto task = queue.next({}, kNow)) tasks.push_back(*task);
  return tasks;
}

}  // namespace

TEST_CASE("tasks come out in the order in which they were given") {
  TaskQueue<int> queue(10);
  for (const int task : {3, 1, 2}) queue.give(task);
  CHECK(left_in(queue) == std::vector{3, 1, 2});
  CHECK(queue.dropped() == 0);
}

TEST_CASE("in a full queue the oldest task makes way, and is counted") {
  TaskQueue<int> queue(3);
  for (const int task : {1, 2, 3, 4, 5}) queue.give(task);
  CHECK(queue.dropped() == 2);
  CHECK(left_in(queue) == std::vector{3, 4, 5});
}

TEST_CASE("many tasks of one kind push out none of another kind") {
  TaskQueue<int> queue(3, parity);
  for (const int task : {1, 2, 4, 6, 8, 3, 10}) queue.give(task);
  CHECK(queue.dropped() == 2);
  CHECK(left_in(queue) == std::vector{1, 6, 8, 3, 10});
}

TEST_CASE("a queue is drained when its last task is done, not when it is taken") {
  TaskQueue<int> queue(10);
  CHECK(queue.drain(0));
  queue.give(1);
  CHECK_FALSE(queue.drain(0));
  REQUIRE(queue.next({}, kNow));
  CHECK_FALSE(queue.drain(0));
  CHECK_FALSE(queue.next({}, kNow));
  CHECK(queue.drain(0));
}

TEST_CASE("a thread that waits for tasks gets those that come, and ends when it is to end") {
  TaskQueue<int> queue(10);
  std::vector<int> done;
  {
    const std::jthread thread([&](const std::stop_token& stop) {
      while (const auto task = queue.next(stop, kLong)) done.push_back(*task);
    });
    for (int task = 0; task < 100; ++task) {
      queue.give(task);
      if (task % 10 == 9) REQUIRE(queue.drain(60));
    }
  }
  CHECK(done.size() == 100);
}
