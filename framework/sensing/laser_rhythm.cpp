#include "sensing/laser_rhythm.hpp"

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

constexpr int kMostAveraged = 50;
constexpr double kShortest_s = 0.005, kLongest_s = 1;
constexpr double kSilentIntervals = 3, kSilentAfter_s = 0.5;  // whichever is longer
constexpr double kEarly = 0.25;                               // of an interval

}  // namespace

void LaserRhythm::scanned(double stamp_s) {
  const double since_s = stamp_s - last_s_;
  last_s_ = std::max(last_s_, stamp_s);
  if (!std::isfinite(since_s) || since_s <= 0) return;
  mean_interval_s_ += (since_s - mean_interval_s_) / std::min(++intervals_, kMostAveraged);
  // The smaller of two: a lost scan doubles only one of them.
  interval_s_ = std::clamp(before_s_ > 0 ? std::min(before_s_, since_s) : since_s, kShortest_s, kLongest_s);
  before_s_ = since_s;
}

bool LaserRhythm::is_due_until(double stamp_s, double now_s) const {
  if (!std::isfinite(last_s_)) return false;
  if (now_s > last_s_ + std::max(kSilentAfter_s, kSilentIntervals * interval_s_)) return false;
  return last_s_ + (1 - kEarly) * interval_s_ <= stamp_s;
}

}  // namespace opal
