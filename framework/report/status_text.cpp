#include "report/status_text.hpp"

namespace opal {

std::string status_text(const std::string& status, double probability) {
  constexpr double kFound = 0.5;  // more probable than everything else together
  if (status != "searching" || probability <= kFound) return status;
  return status + " (a place is found, but not proven yet)";
}

}  // namespace opal
