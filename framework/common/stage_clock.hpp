#pragma once

#include <ctime>

namespace opal {

/// CPU time [s] that a clock of this process has counted.
inline double cpu_s(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

inline double thread_cpu_s() { return cpu_s(CLOCK_THREAD_CPUTIME_ID); }
inline double process_cpu_s() { return cpu_s(CLOCK_PROCESS_CPUTIME_ID); }

/// Adds the CPU time of a scope to a stage.
class StageClock {
 public:
  explicit StageClock(double& stage_s) : stage_s_(stage_s), start_s_(thread_cpu_s()) {}
  ~StageClock() { stage_s_ += thread_cpu_s() - start_s_; }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

 private:
  double& stage_s_;
  double start_s_;
};

}  // namespace opal
