#include "benchmark/experiments/kit/in_parallel.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

using opal::experiments::in_parallel;

TEST_CASE("all work is done once, on however many threads") {
  const int jobs = GENERATE(1, 2, 7);
  std::vector<int> done(100, 0);
  in_parallel(done.size(), jobs, [&](std::size_t k) { ++done[k]; });
  CHECK(done == std::vector<int>(100, 1));
  in_parallel(0, jobs, [&](std::size_t) { FAIL("there is no work"); });
}

TEST_CASE("what has not begun when a stop is asked for is left undone") {
  const int jobs = GENERATE(1, 3);
  std::stop_source stop;
  std::vector<int> done(1000, 0);
  in_parallel(
      done.size(), jobs,
      [&](std::size_t k) {
        done[k] = 1;
        if (k == 5) stop.request_stop();
      },
      stop.get_token());
  CHECK(done[5] == 1);
  CHECK(done.back() == 0);
}

TEST_CASE("what is thrown on a thread comes out, and no more work is begun") {
  const int jobs = GENERATE(1, 3);
  std::vector<int> done(1000, 0);
  CHECK_THROWS_AS(in_parallel(done.size(), jobs,
                              [&](std::size_t k) {
                                if (k == 5) throw std::runtime_error("five");
                                std::this_thread::sleep_for(std::chrono::milliseconds(1));  // or all is over before
                                done[k] = 1;
                              }),
                  std::runtime_error);
  CHECK(done.back() == 0);
}
