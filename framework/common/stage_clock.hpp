#pragma once

#include "common/cpu_clock.hpp"

namespace opal {

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
