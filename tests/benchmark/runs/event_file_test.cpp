#include "benchmark/runs/event_file.hpp"

#include "common/write_error.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <sstream>

using namespace opal;

namespace {

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (file.eof()) line += " (cut off)";
    lines.push_back(line);
  }
  return lines;
}

/// No file may be larger than this while it lives, as on a disk that is nearly full.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

}  // namespace

TEST_CASE("events stand in the file line by line, the last ones too") {
  const TemporaryFolder folder;
  {
    opal::benchmark::EventFile events(folder.path_of("events.jsonl"));
    for (int k = 0; k < 10000; ++k) events.write({{"event", "e"}, {"number", k}});
    events.finish();
  }
  const auto lines = lines_of(folder.path_of("events.jsonl"));
  REQUIRE(lines.size() == 10000);
  CHECK(lines.front() == R"({"event":"e","number":0})");
  CHECK(lines.back() == R"({"event":"e","number":9999})");
}

TEST_CASE("a file that can grow no more ends with a whole event, and the cause is said") {
  const TemporaryFolder folder;
  const std::string path = folder.path_of("events.jsonl");
  {
    const FileSizeLimit limit(100'003);
    opal::benchmark::EventFile events(path);
    const auto write_too_many = [&] {
      for (int k = 0; k < 10000; ++k) events.write({{"event", "e"}, {"number", k}});
    };
    CHECK_THROWS_AS(write_too_many(), WriteError);
  }
  const auto lines = lines_of(path);
  REQUIRE(lines.size() > 3000);
  for (std::size_t k = 0; k < lines.size(); ++k)
    REQUIRE(lines[k] == R"({"event":"e","number":)" + std::to_string(k) + "}");
}

TEST_CASE("a file that cannot be made is named") {
  CHECK_THROWS_WITH(opal::benchmark::EventFile("/dev/null/events.jsonl"),
                    "/dev/null/events.jsonl: cannot be written: Not a directory");
}
