#include "report/quantity_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace opal {

std::string fixed_text(double value, int decimals) {
  constexpr double kLargestWritten = 1e12;  // stamps since 1970 are no absurd values
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return value < 0 ? "-∞" : "∞";
  if (std::abs(value) >= kLargestWritten) return fmt::format("{:g}", value);
  const double scale = std::pow(10.0, decimals);
  const double rounded = std::round(value * scale) / scale;
  return fmt::format("{:.{}f}", rounded == 0 ? 0.0 : rounded, decimals);
}

std::string interval_text(double low, double high, int decimals) {
  return fixed_text(low, decimals) + " to " + fixed_text(high, decimals);
}

std::string within_text(double value, double low, double high, int decimals) {
  return fmt::format("{} ({})", fixed_text(value, decimals), interval_text(low, high, decimals));
}

std::string p_text(double p) {
  constexpr double kSmallest = 1e-4;
  return p < kSmallest ? "< 0.0001" : fixed_text(p, p < 0.01 ? 4 : 3);
}

std::string place_text(const Point& place) {
  return fmt::format("({}, {})", fixed_text(place.x(), 2), fixed_text(place.y(), 2));
}

std::string pose_text(const Pose2& pose) {
  return fmt::format("{}, heading {} deg", place_text(pose.position()), fixed_text(degrees(pose.heading_rad()), 1));
}

}  // namespace opal
