#include "benchmark/experiments/challenges/baseline.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <sstream>

namespace opal::experiments {
namespace {

constexpr const char* kHeader = "timestamp,x,y,theta,localized,hypotheses,cpu_ms";

void run_to_its_end(std::vector<std::string> command) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (const int wrong = posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ); wrong != 0)
    throw Error(command[0] + ": cannot be started: " + std::strerror(wrong));
  int status = 0;
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error(command[0] + ": failed, expected exit code 0");
}

/// What a baseline said at a time.
struct Row {
  double stamp_s = 0;
  Pose2 T_map_laser;
  bool localized = false;
  int hypotheses = 0;
  double cpu_ms = 0;
};

Row row_of(const std::string& line, const std::string& where) {
  std::istringstream text(line);
  std::vector<double> numbers;
  for (std::string cell; std::getline(text, cell, ',');) try {
      std::size_t end = 0;
      numbers.push_back(std::stod(cell, &end));
      if (end != cell.size()) throw std::invalid_argument(cell);
    } catch (const std::exception&) {
      throw LogError(where + ": '" + cell + "', expected a number");
    }
  if (numbers.size() != 7) throw LogError(fmt::format("{}: {} columns, expected {}", where, numbers.size(), kHeader));
  return {numbers[0], Pose2(numbers[1], numbers[2], numbers[3]), numbers[4] != 0, static_cast<int>(numbers[5]),
          numbers[6]};
}

std::vector<Row> rows_of(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != kHeader)
    throw LogError(path + ": line 1: '" + line + "', expected " + kHeader);
  std::vector<Row> rows;
  for (int number = 2; std::getline(file, line); ++number)
    rows.push_back(row_of(line, path + ": line " + std::to_string(number)));
  return rows;
}

}  // namespace

std::vector<JudgedMoment> read_baseline(const std::string& path, const simulation::Recording& recording) {
  const std::vector<Row> rows = rows_of(path);
  const Pose2 T_laser_base = recording.laser.T_base_laser.inverse();
  constexpr double kSame_s = 0.01;
  std::vector<JudgedMoment> moments;
  std::size_t next = 0;
  for (const simulation::RecordedScan& recorded : recording.scans) {
    JudgedMoment moment;
    moment.time_s = recorded.scan.stamp_s - recording.scans.front().scan.stamp_s;
    moment.truth = recorded.T_map_base;
    if (!moments.empty()) moment.driven_m = moments.back().driven_m + distance_m(moments.back().truth, moment.truth);
    while (next < rows.size() && rows[next].stamp_s < recorded.scan.stamp_s - kSame_s) ++next;
    if (next < rows.size() && rows[next].stamp_s < recorded.scan.stamp_s + kSame_s) {
      moment.estimate = rows[next].T_map_laser * T_laser_base;
      moment.has_pose = true;
      moment.status = rows[next].localized ? Status::localized : Status::ambiguous;
      moment.hypotheses = rows[next].hypotheses;
      moment.cpu_ms = rows[next].cpu_ms;
    }
    moments.push_back(moment);
  }
  return moments;
}

ChallengeRun run_baseline(const Baseline& baseline, const simulation::ChallengeDrive& driven, const std::string& prefix,
                          const std::string& grid_yaml, std::uint64_t seed) {
  const std::string answer = prefix + '.' + baseline.name + ".csv";
  std::vector<std::string> command{
      baseline.program,     "--map", grid_yaml, "--log", prefix + ".log.gz", "--laser", prefix + ".info.json", "--seed",
      std::to_string(seed), "--out", answer};
  if (driven.region) {
    std::ostringstream region;
    region << driven.region->center.x() << ',' << driven.region->center.y() << ',' << driven.region->radius_m;
    command.insert(command.end(), {"--region", region.str()});
  }
  simulation::write_recording(driven.recording, prefix);
  run_to_its_end(std::move(command));
  ChallengeRun run;
  run.contender = baseline.name;
  run.region = driven.region;
  run.moments = read_baseline(answer, driven.recording);
  judge(run);
  return run;
}

}  // namespace opal::experiments
