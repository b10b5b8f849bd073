#include "report/status_text.hpp"

#include <algorithm>

namespace opal {

std::string status_text(const std::string& status, double probability) {
  constexpr double kFound = 0.5;  // more probable than everything else together
  if (status != "searching" || probability <= kFound) return status;
  return status + " (a place is found, but not proven yet)";
}

std::string reason_text(const std::string& status, const std::string& why, std::span<const std::string> of_sensor) {
  if (status == "localized" || why.empty()) return "";
  if (std::find(of_sensor.begin(), of_sensor.end(), why) != of_sensor.end())
    return "the sensor is not as described, so nothing is called localized: " + why;
  return (status == "lost" ? "lost: " : "not localized yet, it waits for more evidence: ") + why;
}

}  // namespace opal
