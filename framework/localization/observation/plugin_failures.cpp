#include "localization/observation/plugin_failures.hpp"

#include <spdlog/spdlog.h>

namespace opal {

void PluginFailures::count(const std::string& plugin, const std::string& cause) {
  if (counts_[plugin]++ == 0) spdlog::warn("{}: skipped: {}", plugin, cause);
}

}  // namespace opal
