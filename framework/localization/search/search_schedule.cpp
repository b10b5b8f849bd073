#include "localization/search/search_schedule.hpp"

namespace opal {

bool SearchSchedule::is_chance(const Pose2& T_odom_base) const {
  return !T_odom_base_ || distance_m(*T_odom_base_, T_odom_base) > options_.every_m ||
         angle_between_rad(*T_odom_base_, T_odom_base) > options_.every_rad;
}

bool SearchSchedule::time_to_search(const Pose2& T_odom_base, bool at_once, int every) {
  if (!at_once && !is_chance(T_odom_base)) return false;
  T_odom_base_ = T_odom_base;
  if (++chances_passed_ < every) return false;
  chances_passed_ = 0;
  return true;
}

void SearchSchedule::reset() {
  T_odom_base_.reset();
  chances_passed_ = 0;
}

}  // namespace opal
