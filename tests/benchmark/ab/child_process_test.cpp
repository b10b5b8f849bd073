#include "benchmark/ab/execution/child_process.hpp"
#include "benchmark/ab/execution/claim.hpp"

#include "small_experiment.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <vector>

using namespace opal::ab;
using opal::TemporaryFolder;

namespace {

/// All that a child says, and its failure behind it.
std::vector<std::string> heard(const std::function<void(const ChildProcess::Say&)>& work, double wall_s = 60,
                               double memory_mb = 1e6) {
  ChildProcess child(work);
  std::vector<std::string> all;
  for (;;) {
    const Answer answer = next_answer(child, wall_s, memory_mb);
    all.push_back(answer.given ? answer.line : answer.failure);
    if (!answer.given) return all;
  }
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("a child says its lines and comes to its end") {
  const std::string long_line(100'000, 'x');
  CHECK(heard([&](const ChildProcess::Say& say) {
          say("one");
          say(long_line);
        }) == Lines{"one", long_line, ""});
}

TEST_CASE("how a child ended is told") {
  CHECK(heard([](const ChildProcess::Say& say) {
          say("one");
          throw opal::Error("so\nso");
        }) == Lines{"one", "threw: so so"});
  CHECK(heard([](const ChildProcess::Say&) { throw 3; }) == Lines{"threw: something that is no std::exception"});
  CHECK(heard([](const ChildProcess::Say&) { std::abort(); }) == Lines{"crashed: signal 6 (SIGABRT)"});
  CHECK(heard([](const ChildProcess::Say&) { _exit(3); }) == Lines{"ended by itself with 3"});
}

TEST_CASE("a child that takes too long or too much is ended") {
  CHECK(heard([](const ChildProcess::Say&) { pause(); }, 0.2) == Lines{"hung: over 0.2 s"});
  const auto eat = [](const ChildProcess::Say&) {
    for (std::vector<std::vector<char>> eaten;;) eaten.emplace_back(1u << 20, 'x');
  };
  CHECK(heard(eat, 60, 300) == Lines{"out of memory: over 300 MB"});
}

TEST_CASE("tasks that one process has claimed are refused to others, and free again when it has ended") {
  const TemporaryFolder folder;
  ChildProcess other([&](const ChildProcess::Say& say) {
    Claim claim(folder.path(), 10, 20);
    say("claimed");
    pause();
  });
  REQUIRE(next_answer(other, 60, 1e6).given);
  CHECK_NOTHROW(Claim(folder.path(), 0, 10));
  CHECK_NOTHROW(Claim(folder.path(), 20, 30));
  CHECK_THROWS_WITH(Claim(folder.path(), 19, 21),
                    Catch::StartsWith(folder.path() + ": process ") && Catch::Contains("computes these cells already"));
  other.end();
  CHECK_NOTHROW(Claim(folder.path(), 0, 30));
}
