// A job array under a real Slurm gives what this machine gives by itself.
#include <catch2/catch.hpp>

#include "slurm_server.hpp"

#include "tests/benchmark/ab/small_experiment.hpp"
#include "tests/kit/run_tests.hpp"
#include "tests/system/server/program.hpp"

#include <chrono>
#include <iostream>
#include <thread>

using namespace opal::ab_tests;
using opal::TemporaryFolder;
using opal::store_tests::Finished;
using opal::store_tests::opal_run;

namespace {

/// Waits until `opal ab status` says that all is finished. @return what it said last.
Finished waited(const std::vector<std::string>& status) {
  Finished last;
  for (int k = 0; k < 600; ++k) {
    last = opal_run(status);
    if (last.exit_code != 1) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
  }
  return last;
}

}  // namespace

TEST_CASE("a Slurm job array computes the same results, byte for byte, as one machine") {
  const TemporaryFolder folder;
  const std::string experiment = written(folder, experiment_with_drives());
  const std::string here = folder.path_of("here"), cluster = folder.path_of("cluster");
  REQUIRE(opal_run({"ab", experiment, "-o", here}).exit_code == 0);
  const std::string expected = content_of(here + "/results.jsonl");

  const Finished submitted =
      opal_run({"ab", "submit", experiment, "-o", cluster, "--tasks", "3", "--sbatch=--time=10"});
  INFO(submitted.said);
  REQUIRE(submitted.exit_code == 0);
  CHECK_THAT(submitted.said, Catch::Contains("an array of 3 tasks"));
  const Finished status = waited({"ab", "status", experiment, "-o", cluster});
  INFO(status.said);
  REQUIRE(status.exit_code == 0);
  CHECK_THAT(status.said, Catch::Contains("22 of 22 cells are finished"));
  REQUIRE(opal_run({"ab", "collect", experiment, "-o", cluster}).exit_code == 0);
  CHECK(content_of(cluster + "/results.jsonl") == expected);
}

TEST_CASE("what sbatch refuses is told in its words") {
  const TemporaryFolder folder;
  const Finished refused = opal_run({"ab", "submit", written(folder, small_experiment()), "-o", folder.path_of("out"),
                                     "--sbatch=--partition=nowhere"});
  CHECK(refused.exit_code == 3);
  CHECK_THAT(refused.said, Catch::Contains("invalid partition specified: nowhere"));
}

int main(int argc, char** argv) {
  if (const std::string why = SlurmServer::why_not(); !why.empty()) {
    std::cout << "skipped: " << why << '\n';
    return 77;
  }
  const SlurmServer server;
  return run_tests(argc, argv);
}
