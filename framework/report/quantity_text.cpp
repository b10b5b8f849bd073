#include "report/quantity_text.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace opal {

std::string fixed_text(double value, int decimals) {
  constexpr double kLargestWritten = 1e9;
  char text[64];
  if (!(std::abs(value) < kLargestWritten)) {
    std::snprintf(text, sizeof text, "%g", value);
    return text;
  }
  const double scale = std::pow(10.0, decimals);
  const double rounded = std::round(value * scale) / scale;
  std::snprintf(text, sizeof text, "%.*f", decimals, rounded == 0 ? 0.0 : rounded);
  return text;
}

std::string place_text(const Point& place) {
  return "(" + fixed_text(place.x(), 2) + ", " + fixed_text(place.y(), 2) + ")";
}

std::string pose_text(const Pose2& pose) {
  return place_text(pose.position()) + ", heading " + fixed_text(pose.heading_rad() * 180 / std::numbers::pi, 1) +
         " deg";
}

std::string count_text(std::size_t count, const std::string& singular) {
  return std::to_string(count) + " " + singular + (count == 1 ? "" : "s");
}

}  // namespace opal
