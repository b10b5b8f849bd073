#include "benchmark/experiments/integrity/localized_time.hpp"

#include <algorithm>

namespace opal::experiments {

void LocalizedTime::add(double stamp_s, bool is_localized, bool is_right) {
  constexpr double kSilence_s = 1;
  const double step_s = std::clamp(stamp_s - before_s_, 0.0, kSilence_s);
  before_s_ = std::max(before_s_, stamp_s);
  if (!is_localized || is_right) stretch_s_ = 0;
  if (!is_localized) return;
  if (is_right) {
    right_s += step_s;
    return;
  }
  if (!wrong_from_s) wrong_from_s = stamp_s;
  wrong_s += step_s;
  stretch_s_ += step_s;
  longest_wrong_s = std::max(longest_wrong_s, stretch_s_);
}

}  // namespace opal::experiments
