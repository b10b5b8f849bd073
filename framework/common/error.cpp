#include <opal/common/error.hpp>

namespace opal {

// Out of line: one vtable and one typeinfo, in libopal.so, for all plugins.
Error::~Error() = default;
ConfigError::~ConfigError() = default;
MapError::~MapError() = default;
LogError::~LogError() = default;
EventError::~EventError() = default;
PluginError::~PluginError() = default;

}  // namespace opal
