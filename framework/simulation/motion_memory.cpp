#include "simulation/motion_memory.hpp"

#include <algorithm>

namespace opal::simulation {

void MotionMemory::add(const Moment& now, double keep_s) {
  if (!moments_.empty() && moments_.back().stamp_s >= now.stamp_s) moments_.pop_back();
  moments_.push_back(now);
  while (moments_.size() > 2 && moments_[1].stamp_s <= now.stamp_s - keep_s) moments_.pop_front();
}

MotionMemory::Moment MotionMemory::at(double stamp_s) const {
  const auto after = std::ranges::lower_bound(moments_, stamp_s, {}, &Moment::stamp_s);
  if (after == moments_.begin()) return moments_.front();
  if (after == moments_.end()) return moments_.back();
  const Moment& before = *std::prev(after);
  const double share = (stamp_s - before.stamp_s) / (after->stamp_s - before.stamp_s);
  return {stamp_s, interpolated(before.T_map_base, after->T_map_base, share),
          interpolated(before.T_odom_base, after->T_odom_base, share)};
}

}  // namespace opal::simulation
