#include "report/status_text.hpp"

namespace opal {

std::string status_text(const std::string& status, double probability) {
  constexpr double kFound = 0.5;  // more probable than everything else together
  if (status != "searching" || probability <= kFound) return status;
  return status + " (a place is found, but not proven yet)";
}

std::string reason_text(const std::string& status, const std::string& why) {
  if (status == "localized" || why.empty()) return "";
  return (status == "lost" ? "lost: " : "not localized yet, it waits for more evidence: ") + why;
}

}  // namespace opal
