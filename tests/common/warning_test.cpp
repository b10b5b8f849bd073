#include "tests/kit/file_content.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/warning.hpp>

#include <spdlog/spdlog.h>
#include <catch2/catch.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace opal;

namespace {

/// What goes to stderr while a function runs.
template <class Function>
std::string on_stderr(const Function& run) {
  const TemporaryFile file("stderr", "");
  const int usual = dup(STDERR_FILENO), captured = open(file.path().c_str(), O_WRONLY | O_APPEND);
  dup2(captured, STDERR_FILENO);
  run();
  dup2(usual, STDERR_FILENO);
  close(captured);
  close(usual);
  return content_of(file.path());
}

/// Warnings go here until this ends.
struct Taken {
  Taken() {
    set_warning_sink([this](std::string_view line) { lines.emplace_back(line); });
  }
  ~Taken() { set_warning_sink({}); }
  Taken(const Taken&) = delete;
  Taken& operator=(const Taken&) = delete;

  std::vector<std::string> lines;
};

constexpr int kThreads = 4, kEach = 200;

/// Each thread warns of "THREAD: NUMBER", padded so that pieces of lines would be seen.
void warn_from_threads() {
  std::vector<std::jthread> threads;
  for (int thread = 0; thread < kThreads; ++thread)
    threads.emplace_back([thread] {
      for (int k = 0; k < kEach; ++k) warn(std::to_string(thread) + ": " + std::string(60, 'x') + std::to_string(k));
    });
}

std::vector<std::string> all_of_threads() {
  std::vector<std::string> lines;
  for (int thread = 0; thread < kThreads; ++thread)
    for (int k = 0; k < kEach; ++k)
      lines.push_back(std::to_string(thread) + ": " + std::string(60, 'x') + std::to_string(k));
  return lines;
}

}  // namespace

TEST_CASE("a warning is a line of stderr, as it is written") {
  const std::string said = on_stderr([] {
    warn("a plugin: skipped: {}");
    warn("100 %s");
  });
  CHECK(said == "a plugin: skipped: {}\n100 %s\n");
}

TEST_CASE("an embedding program takes the warnings, and gives them back") {
  const std::string said = on_stderr([] {
    {
      const Taken taken;
      warn("for the program");
      CHECK(taken.lines == std::vector<std::string>{"for the program"});
    }
    warn("for stderr");
  });
  CHECK(said == "for stderr\n");
}

TEST_CASE("lines of several threads are whole, on stderr and in a sink that locks nothing") {
  CHECK_THAT(lines_of(on_stderr(warn_from_threads)), Catch::UnorderedEquals(all_of_threads()));
  Taken taken;
  warn_from_threads();
  CHECK_THAT(taken.lines, Catch::UnorderedEquals(all_of_threads()));
}

TEST_CASE("a sink that throws stops nobody, and is told on stderr") {
  const std::string said = on_stderr([] {
    set_warning_sink([](std::string_view) { throw std::runtime_error("the log of the robot is full"); });
    CHECK_NOTHROW(warn("something"));
    set_warning_sink({});
  });
  CHECK_THAT(said, Catch::Contains("the log of the robot is full"));
}

TEST_CASE("warnings leave the loggers of the process alone") {
  const auto usual = spdlog::default_logger();
  const Taken taken;
  warn("something");
  CHECK(spdlog::default_logger() == usual);
  CHECK(spdlog::get("opal") == nullptr);
}
