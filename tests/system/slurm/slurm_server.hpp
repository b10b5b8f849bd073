#pragma once

#include "benchmark/ab/execution/child_process.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <memory>
#include <string>
#include <vector>

namespace opal::ab_tests {

/// A Slurm of one node with its files in a temporary folder and its doors on 127.0.0.1 only: munged, slurmctld, slurmd.
/// It ends with this object, and with the process at the latest.
class SlurmServer {
 public:
  /// Why there can be none here; empty: there can.
  static std::string why_not();

  /// Starts it and sets SLURM_CONF of this process. @throws std::runtime_error if it does not come up.
  SlurmServer();
  SlurmServer(const SlurmServer&) = delete;
  SlurmServer& operator=(const SlurmServer&) = delete;

 private:
  void run(const std::vector<std::string>& words);
  void wait_until_ready() const;

  TemporaryFolder folder_;
  std::vector<std::unique_ptr<ab::ChildProcess>> programs_;
};

}  // namespace opal::ab_tests
