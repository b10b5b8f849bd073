#include <opal/plugin/plugin_folders.hpp>

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace opal {
namespace {

namespace fs = std::filesystem;

fs::path folder_of_this_library() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&own_plugin_folder), &info) == 0 || info.dli_fname == nullptr)
    return fs::current_path();
  return fs::weakly_canonical(info.dli_fname).parent_path();
}

std::string normal_form(const fs::path& folder) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(folder, error);
  return (error ? folder : canonical).string();
}

}  // namespace

std::string own_plugin_folder() {
  const fs::path libraries = folder_of_this_library();
  const fs::path installed = libraries / "opal" / "plugins";
  const fs::path built = libraries.parent_path() / "plugins";
  return (fs::is_directory(installed) || !fs::is_directory(built) ? installed : built).string();
}

std::vector<std::string> plugin_folders() {
  std::vector<std::string> folders{own_plugin_folder()};
  const char* added = std::getenv("OPAL_PLUGIN_PATH");
  std::istringstream path(added == nullptr ? "" : added);
  for (std::string entry; std::getline(path, entry, ':');) {
    const std::string folder = normal_form(entry);
    if (!entry.empty() && std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
  }
  return folders;
}

}  // namespace opal
