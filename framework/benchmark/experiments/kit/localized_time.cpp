#include "benchmark/experiments/kit/localized_time.hpp"

#include <algorithm>

namespace opal::experiments {

void LocalizedTime::add(double stamp_s, bool is_localized, bool is_right) {
  constexpr double kSilence_s = 1;
  const double since_s = stamp_s - before_s_;
  hold(std::clamp(since_s, 0.0, kSilence_s));
  before_s_ = std::max(before_s_, stamp_s);
  is_localized_ = is_localized;
  is_right_ = is_right;
  const bool is_wrong = is_localized && !is_right;
  if (!is_wrong || since_s > kSilence_s) stretch_s_ = 0;
  if (is_wrong && !wrong_from_s) wrong_from_s = stamp_s;
}

void LocalizedTime::hold(double time_s) {
  if (!is_localized_) return;
  if (is_right_) {
    right_s += time_s;
    return;
  }
  wrong_s += time_s;
  stretch_s_ += time_s;
  longest_wrong_s = std::max(longest_wrong_s, stretch_s_);
}

}  // namespace opal::experiments
