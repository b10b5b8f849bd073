#include "localization/observation/plugin_failures.hpp"

#include <opal/common/warning.hpp>

namespace opal {

void PluginFailures::count(const std::string& plugin, const std::string& cause) {
  if (counts_[plugin]++ == 0) warn(plugin + ": skipped: " + cause);
}

}  // namespace opal
