#include "deployment/cache_folder.hpp"

#include <cstdlib>

namespace opal {

std::filesystem::path cache_folder(const char* variable, const std::string& name) {
  if (const char* folder = std::getenv(variable)) return folder;
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0')
    return std::filesystem::path(cache) / "opal" / name;
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return std::filesystem::path(home) / ".cache" / "opal" / name;
  return {};
}

}  // namespace opal
