#include "deployment/cache_folder.hpp"

#include <cstdlib>

namespace opal {
namespace {

namespace fs = std::filesystem;

/// A folder for everybody's files of one kind (XDG Base Directory Specification).
struct BaseFolder {
  const char* variable;  ///< that names it
  const char* in_home;   ///< where it is otherwise
};

bool is_set(const char* value) { return value != nullptr && *value != '\0'; }

fs::path folder_in(const BaseFolder& base, const char* variable, const std::string& name) {
  if (const char* folder = std::getenv(variable)) return folder;
  if (const char* folder = std::getenv(base.variable); is_set(folder)) return fs::path(folder) / "opal" / name;
  if (const char* home = std::getenv("HOME"); is_set(home)) return fs::path(home) / base.in_home / "opal" / name;
  return {};
}

}  // namespace

fs::path cache_folder(const char* variable, const std::string& name) {
  return folder_in({"XDG_CACHE_HOME", ".cache"}, variable, name);
}

fs::path state_folder(const char* variable, const std::string& name) {
  return folder_in({"XDG_STATE_HOME", ".local/state"}, variable, name);
}

}  // namespace opal
