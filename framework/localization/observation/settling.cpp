#include "localization/observation/settling.hpp"

#include "common/pose_tolerance.hpp"

#include <cmath>

namespace opal {
namespace {

constexpr PoseTolerance kAtRest{0.01, 0.005};
constexpr double kFirst_s = 0.2;  // after the stop; then after twice that, and so on
constexpr int kLooks = 4;

}  // namespace

bool Settling::add(double stamp_s, const Pose2& T_odom_base) {
  const bool rests = stamp_s >= rest_s_ && kAtRest.holds(T_odom_base, T_odom_rest_);
  if (!rests) {
    rest_s_ = stamp_s;
    T_odom_rest_ = T_odom_base;
    looks_ = 0;
    return false;
  }
  if (looks_ == kLooks || stamp_s - rest_s_ < std::ldexp(kFirst_s, looks_)) return false;
  ++looks_;
  return true;
}

}  // namespace opal
